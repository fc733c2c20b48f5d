(* Answers queries with the functions that are proved. A line of stdin is a query, a line of stdout its answer:

   sweep MARGIN POSITION DISPLACEMENT A B VERTICES   "far" when the boxes reject it, "miss", or the quotient of the time,
                                                     that of the exit, the side, the normal, and the feature
   shape VERTICES                                    "valid" or "refused"
   place COSINE SINE HOME_ANCHOR ANCHOR HOME         "at", and the position of the instance

   Points are two numbers each. *)
let z = Big_int_Z.big_int_of_int
let string = Big_int_Z.string_of_big_int

let rec points = function
  | [] -> []
  | x :: y :: rest -> { Proved.x = z x; y = z y } :: points rest
  | _ -> failwith "a point has two coordinates"

let text_of_point p = string p.Proved.x ^ " " ^ string p.Proved.y
let text_of_fraction f = string f.Proved.numerator ^ " " ^ string f.Proved.denominator

let sweep margin position displacement segment vertices =
  let bounds = Proved.boundsOfSweep vertices position displacement margin in
  match Proved.clipAgainst vertices segment position displacement margin with
  | None -> if Proved.overlapsBox bounds (Proved.boundsOf segment) then "miss" else "far"
  | Some interval when Proved.overlapsBox bounds (Proved.boundsOf segment) ->
      let hit = Proved.hitOf vertices segment interval in
      let side = match hit.side0 with KInside -> "0" | KSegment -> "1" | KSegmentEnd -> "2" in
      String.concat " "
        [ text_of_fraction hit.time; text_of_fraction hit.exit_; side; text_of_point hit.normal_; text_of_point hit.feature ]
  | Some _ -> if Big_int_Z.sign_big_int margin = 0 then "a hit that the boxes reject" else "far"

let answer line =
  let kind, numbers =
    match String.split_on_char ' ' line with
    | kind :: rest -> (kind, List.map int_of_string rest)
    | [] -> ("", []) in
  match (kind, numbers) with
  | "sweep", margin :: rest -> (
      match points rest with
      | position :: displacement :: a :: b :: vertices -> sweep (z margin) position displacement { Proved.a; b } vertices
      | _ -> failwith ("not a query: " ^ line))
  | "shape", rest -> if Proved.isValid (points rest) then "valid" else "refused"
  | "place", cosine :: sine :: rest -> (
      match points rest with
      | [ homeAnchor; anchor; home ] ->
          let fromHome = { Proved.cosine = z cosine; sine = z sine } in
          "at " ^ text_of_point (Proved.placeOf { Proved.fromHome; homeAnchor; anchor } home)
      | _ -> failwith ("not a query: " ^ line))
  | _ -> failwith ("not a query: " ^ line)

let () =
  try
    while true do
      print_string (answer (input_line stdin)); print_char (Char.chr 10)
    done
  with End_of_file -> ()
