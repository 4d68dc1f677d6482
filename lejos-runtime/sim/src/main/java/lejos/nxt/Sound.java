package lejos.nxt;

import arcomat.sim.device.Hardware;

/** The speaker. */
public class Sound {
    public static final int VOL_MAX = 100;

    private static final Hardware BRICK = Hardware.of(Sound.class);
    private static final int BEEP = 600;
    private static final int BEEP_LENGTH = 200;
    private static final int BUZZ = 100;
    private static final int BUZZ_LENGTH = 500;
    private static final int[] SEQUENCE = {523, 659, 784, 1047};
    private static final int SEQUENCE_LENGTH = 150;

    private Sound() {}

    public static void playTone(int aFrequency, int aDuration) {
        BRICK.called().speaker().play(aFrequency, aDuration);
    }

    /** Loudness is not simulated. */
    public static void playTone(int freq, int duration, int vol) {
        playTone(freq, duration);
    }

    public static void beep() {
        systemSound(false, 0);
    }

    public static void twoBeeps() {
        systemSound(false, 1);
    }

    public static void beepSequence() {
        systemSound(false, 2);
    }

    public static void beepSequenceUp() {
        systemSound(false, 3);
    }

    public static void buzz() {
        systemSound(false, 4);
    }

    public static void systemSound(boolean aQueued, int aCode) {
        switch (aCode) {
            case 0 -> playTone(BEEP, BEEP_LENGTH);
            case 1 -> {
                playAndWait(BEEP, BEEP_LENGTH);
                playAndWait(BEEP, BEEP_LENGTH);
            }
            case 2 -> {
                for (int i = SEQUENCE.length - 1; i >= 0; i--) {
                    playAndWait(SEQUENCE[i], SEQUENCE_LENGTH);
                }
            }
            case 3 -> {
                for (int tone : SEQUENCE) {
                    playAndWait(tone, SEQUENCE_LENGTH);
                }
            }
            default -> playTone(BUZZ, BUZZ_LENGTH);
        }
    }

    private static void playAndWait(int hertz, int milliseconds) {
        playTone(hertz, milliseconds);
        pause(milliseconds);
    }

    public static void pause(int t) {
        BRICK.time().waitUntil(BRICK.tickAfter(t));
    }

    /** Milliseconds until the last tone is over. */
    public static int getTime() {
        return BRICK.called().speaker().remaining();
    }
}
