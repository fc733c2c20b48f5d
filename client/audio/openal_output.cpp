#include "client/audio/openal_output.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <dlfcn.h>

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace platon {
namespace {

static_assert(sizeof(ALuint) == sizeof(std::uint32_t));

ALCdevice* deviceOf(void* device) { return static_cast<ALCdevice*>(device); }

void ignoreMessage(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/,
                   ...) {}

// OpenAL and ALSA write many lines to standard error when there is no device. The caller reports that in one.
void keepLibrariesQuiet() {
  setenv("ALSOFT_LOGLEVEL", "0", 0);
  using SetHandler = int (*)(decltype(&ignoreMessage));
  void* const setHandler = dlsym(RTLD_DEFAULT, "snd_lib_error_set_handler");
  if (setHandler != nullptr) reinterpret_cast<SetHandler>(setHandler)(&ignoreMessage);
}

// Makes a context of the device current. Closes the device and returns null if that fails.
ALCcontext* contextOn(ALCdevice* device, const ALCint* attributes) {
  ALCcontext* const context = alcCreateContext(device, attributes);
  if (context != nullptr && alcMakeContextCurrent(context) == ALC_TRUE) return context;
  if (context != nullptr) alcDestroyContext(context);
  alcCloseDevice(device);
  return nullptr;
}

}  // namespace

std::unique_ptr<OpenalOutput> OpenalOutput::open() {
  keepLibrariesQuiet();
  ALCdevice* const device = alcOpenDevice(nullptr);
  if (device == nullptr) return nullptr;
  const ALCint attributes[] = {ALC_FREQUENCY, kSampleRate, 0};
  ALCcontext* const context = contextOn(device, attributes);
  return context == nullptr ? nullptr : std::unique_ptr<OpenalOutput>(new OpenalOutput(device, context));
}

std::unique_ptr<OpenalOutput> OpenalOutput::openLoopback() {
  keepLibrariesQuiet();
  const auto openDevice =
      reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
  ALCdevice* const device = openDevice == nullptr ? nullptr : openDevice(nullptr);
  if (device == nullptr) return nullptr;
  // Without the limiter, so that what is too loud is seen.
  const ALCint attributes[] = {ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT,
                               ALC_FLOAT_SOFT,           ALC_FREQUENCY,   kSampleRate,
                               ALC_OUTPUT_LIMITER_SOFT,  ALC_FALSE,       0};
  ALCcontext* const context = contextOn(device, attributes);
  return context == nullptr ? nullptr : std::unique_ptr<OpenalOutput>(new OpenalOutput(device, context));
}

OpenalOutput::OpenalOutput(void* device, void* context) : device_(device), context_(context) {
  for (Source& source : sources_) {
    alGenSources(1, &source.name);
    // Sounds are placed around the listener, and do not get softer by distance: the caller has decided how loud they
    // are.
    alSourcei(source.name, AL_SOURCE_RELATIVE, AL_TRUE);
    alSourcef(source.name, AL_ROLLOFF_FACTOR, 0);
  }
  setGain(1);
}

OpenalOutput::~OpenalOutput() {
  for (const Source& source : sources_) alDeleteSources(1, &source.name);
  alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
  alcMakeContextCurrent(nullptr);
  alcDestroyContext(static_cast<ALCcontext*>(context_));
  alcCloseDevice(deviceOf(device_));
}

OpenalOutput::Buffer OpenalOutput::addBuffer(const Pcm& pcm) {
  ALuint name = 0;
  alGenBuffers(1, &name);
  alBufferData(name, pcm.channels == 1 ? AL_FORMAT_MONO16 : AL_FORMAT_STEREO16, pcm.samples.data(),
               static_cast<ALsizei>(pcm.samples.size() * sizeof(std::int16_t)), kSampleRate);
  buffers_.push_back(name);
  return {name};
}

void OpenalOutput::apply(const Source& source) const {
  const double gain = source.gain * groupGains_[static_cast<std::size_t>(source.group)];
  alSourcef(source.name, AL_GAIN, static_cast<ALfloat>(gain));
}

void OpenalOutput::play(Buffer buffer, double gain, double pan, double pitch) {
  for (std::size_t i = 0; i < kSources - kMaxLoops; ++i) {
    Source& source = sources_[i];
    ALint state = AL_INITIAL;
    alGetSourcei(source.name, AL_SOURCE_STATE, &state);
    if (state == AL_PLAYING) continue;
    source.gain = gain;
    apply(source);
    alSourcei(source.name, AL_BUFFER, static_cast<ALint>(buffer.name));
    alSource3f(source.name, AL_POSITION, static_cast<ALfloat>(pan), 0, static_cast<ALfloat>(-std::sqrt(1 - pan * pan)));
    alSourcef(source.name, AL_PITCH, static_cast<ALfloat>(pitch));
    alSourcePlay(source.name);
    return;
  }
}

OpenalOutput::Loop OpenalOutput::startLoop(Buffer buffer, Group group) {
  assert(loops_ < kMaxLoops);
  const std::size_t index = kSources - kMaxLoops + loops_++;
  Source& source = sources_[index];
  source.group = group;
  apply(source);
  alSourcei(source.name, AL_BUFFER, static_cast<ALint>(buffer.name));
  alSourcei(source.name, AL_LOOPING, AL_TRUE);
  alSourcePlay(source.name);
  return {index};
}

void OpenalOutput::setLoop(Loop loop, double gain, double pitch) {
  Source& source = sources_[loop.source];
  source.gain = gain;
  apply(source);
  alSourcef(source.name, AL_PITCH, static_cast<ALfloat>(pitch));
}

void OpenalOutput::setGain(double gain) { alListenerf(AL_GAIN, static_cast<ALfloat>(gain * kHeadroom)); }

void OpenalOutput::setGain(Group group, double gain) {
  double& known = groupGains_[static_cast<std::size_t>(group)];
  if (known == gain) return;
  known = gain;
  for (const Source& source : sources_) {
    if (source.group == group) apply(source);
  }
}

std::size_t OpenalOutput::sounding() const {
  std::size_t count = 0;
  for (const Source& source : sources_) {
    ALint state = AL_INITIAL;
    alGetSourcei(source.name, AL_SOURCE_STATE, &state);
    if (state == AL_PLAYING) ++count;
  }
  return count;
}

std::vector<float> OpenalOutput::render(std::size_t frames) {
  std::vector<float> samples(frames * 2);
  const auto renderSamples =
      reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(deviceOf(device_), "alcRenderSamplesSOFT"));
  renderSamples(deviceOf(device_), samples.data(), static_cast<ALCsizei>(frames));
  return samples;
}

}  // namespace platon
