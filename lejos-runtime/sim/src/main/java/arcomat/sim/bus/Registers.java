package arcomat.sim.bus;

import java.util.Arrays;

/** Fills in answers. */
final class Registers {
    private Registers() {}

    /** A text and zeros behind it. */
    static void text(String text, byte[] answer) {
        Arrays.fill(answer, (byte) 0);
        for (int i = 0; i < Math.min(text.length(), answer.length); i++) {
            answer[i] = (byte) text.charAt(i);
        }
    }

    /** A number in the first place and zeros behind it. */
    static void number(int number, byte[] answer) {
        Arrays.fill(answer, (byte) 0);
        if (answer.length > 0) {
            answer[0] = (byte) number;
        }
    }
}
