package arcomat.benchmarks.network;

import java.util.SplittableRandom;

/** What comes into a network from outside. */
final class Messages {
    /** Slices of a stream. */
    static final int COUNT = 64;

    private Messages() {}

    /** A message in nine slices of ten; 0 is no message. */
    static int[] draw() {
        SplittableRandom random = new SplittableRandom(20130601);
        int[] messages = new int[COUNT];
        for (int i = 0; i < COUNT; i++) {
            messages[i] = random.nextInt(10) == 0 ? 0 : 1 + random.nextInt(1000);
        }
        return messages;
    }
}
