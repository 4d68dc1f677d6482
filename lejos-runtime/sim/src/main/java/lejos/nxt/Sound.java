package lejos.nxt;

import arcomat.sim.device.Hardware;

/** The speaker. Loudness is kept, and not simulated. */
public class Sound {
    public static final int VOL_MAX = 100;
    public static final String VOL_SETTING;

    /** Instruments: how long a note of theirs swells, falls and fades out, and how far. */
    public static final int[] PIANO = {4, 25, 500, 7000, 5};

    public static final int[] FLUTE = {10, 25, 2000, 1000, 25};
    public static final int[] XYLOPHONE = {1, 8, 3000, 5000, 5};

    /** The C above the middle one, in Hertz. */
    public static int C2 = 523;

    private static final Hardware BRICK = Hardware.of(Sound.class);
    private static final int BEEP = 600;
    private static final int BUZZ = 100;
    private static final int USUAL_VOLUME = 80;

    private static int volume;

    static {
        VOL_SETTING = "lejos.volume";
        loadSettings();
    }

    private Sound() {}

    public static void playTone(int freq, int duration) {
        playTone(freq, duration, VOL_MAX);
    }

    public static void playTone(int aFrequency, int aDuration, int aVolume) {
        BRICK.called().speaker().play(aFrequency, aDuration);
    }

    /** A tone that begins with the next tick; its shape cannot be heard in a trace. */
    public static void playNote(int[] inst, int freq, int len) {
        pause(1);
        playTone(freq, len);
        pause(len);
    }

    public static void beep() {
        systemSound(true, 0);
    }

    public static void twoBeeps() {
        systemSound(true, 1);
    }

    /** Downwards. */
    public static void beepSequence() {
        systemSound(true, 3);
    }

    public static void beepSequenceUp() {
        systemSound(true, 2);
    }

    public static void buzz() {
        systemSound(true, 4);
    }

    /** As on the brick, all but the single beep are waited for, and nothing is ever queued. */
    public static void systemSound(boolean aQueued, int aCode) {
        switch (aCode) {
            case 0 -> playTone(BEEP, 200);
            case 1 -> {
                playAndWait(BEEP, 150, 200);
                playAndWait(BEEP, 150, 150);
            }
            case 2 -> {
                for (int quarters = 4; quarters <= 7; quarters++) {
                    playAndWait(C2 * quarters / 4, 100, 100);
                }
            }
            case 3 -> {
                for (int quarters = 7; quarters >= 4; quarters--) {
                    playAndWait(C2 * quarters / 4, 100, 100);
                }
            }
            case 4 -> playAndWait(BUZZ, 500, 500);
            default -> BRICK.called();
        }
    }

    private static void playAndWait(int hertz, int milliseconds, int wait) {
        playTone(hertz, milliseconds);
        pause(wait);
    }

    public static void pause(int t) {
        BRICK.time().waitUntil(BRICK.tickAfter(t));
    }

    /** Milliseconds until the last tone is over. */
    public static int getTime() {
        return BRICK.called().speaker().remaining();
    }

    /** Cut off at 0 and 100. */
    public static void setVolume(int vol) {
        volume = Math.min(Math.max(vol, 0), VOL_MAX);
    }

    public static int getVolume() {
        return volume;
    }

    public static void loadSettings() {
        volume = USUAL_VOLUME;
    }
}
