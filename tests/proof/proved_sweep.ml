(* Answers queries with the function that is proved. A line of stdin is a query: the margin, the position, the
   displacement, both ends of the segment, the number of vertices, the vertices; a line of stdout its answer: "miss", or
   the quotient of the time, that of the exit, the side, the normal, and the feature. *)
let z = Big_int_Z.big_int_of_int
let point x y = { Proved.x = z x; y = z y }

let numbers line = List.map int_of_string (String.split_on_char ' ' line)

let rec vertices = function
  | [] -> []
  | x :: y :: rest -> point x y :: vertices rest
  | _ -> failwith "a vertex has two coordinates"

let answer line =
  match numbers line with
  | margin :: px :: py :: dx :: dy :: ax :: ay :: bx :: by :: count :: rest ->
      let shape = vertices rest in
      if List.length shape <> count then failwith ("not so many vertices: " ^ line);
      let segment = { Proved.a = point ax ay; b = point bx by } in
      (match Proved.clipAgainst shape segment (point px py) (point dx dy) (z margin) with
       | None -> "miss"
       | Some interval ->
           let hit = Proved.hitOf shape segment interval in
           let side = match hit.side0 with KInside -> 0 | KSegment -> 1 | KSegmentEnd -> 2 in
           String.concat " "
             (List.map Big_int_Z.string_of_big_int
                [ hit.time.numerator; hit.time.denominator; hit.exit_.numerator; hit.exit_.denominator; z side;
                  hit.normal_.x; hit.normal_.y; hit.feature.x; hit.feature.y ]))
  | _ -> failwith ("not a query: " ^ line)

let () =
  try
    while true do
      print_string (answer (input_line stdin)); print_char (Char.chr 10)
    done
  with End_of_file -> ()
