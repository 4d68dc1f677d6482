package nxt;

import nxt.Brick.SensorPort;

/** The microphone, sampled once per slice: how loud it is, with the ear of a human. */
<<platform, layer = "sensors">> component SoundSensor(SensorPort socket) {
    /** Loudness in percent of what the sensor can measure, some 90 dB. */
    port <<total>> out Integer[0..100] level;
}
