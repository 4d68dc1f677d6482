package arcomat.benchmarks.step;

import java.util.SplittableRandom;

/**
 * A stream of inputs for AvoidCrash (Fig. 6), the same for every contestant. Codes: 0 is no
 * message, k the k-th constant; gotCoffee is total, so it needs no code for silence.
 */
final class Letters {
    /** Slices of a stream. */
    static final int COUNT = 4096;

    /** Different letters; see {@link #code}. */
    static final int ALPHABET = 3 * 2 * 3 * 2;

    final int[] frontUS = new int[COUNT];
    final int[] timerSig = new int[COUNT];
    final int[] ls = new int[COUNT];
    final boolean[] gotCoffee = new boolean[COUNT];

    /**
     * @param density how often a port carries a message, from 0 to 1
     */
    Letters(double density) {
        SplittableRandom random = new SplittableRandom(20130601);
        for (int slice = 0; slice < COUNT; slice++) {
            frontUS[slice] = message(random, density, 2);
            timerSig[slice] = message(random, density, 1);
            ls[slice] = message(random, density, 2);
            gotCoffee[slice] = random.nextInt(2) == 1;
        }
    }

    private static int message(SplittableRandom random, double density, int constants) {
        return random.nextDouble() < density ? 1 + random.nextInt(constants) : 0;
    }

    /**
     * The whole letter of a slice as one number below {@link #ALPHABET}, for libraries that know
     * events only.
     */
    int code(int slice) {
        return ((frontUS[slice] * 2 + timerSig[slice]) * 3 + ls[slice]) * 2
                + (gotCoffee[slice] ? 1 : 0);
    }

    static int frontUS(int code) {
        return code / 12;
    }

    static int timerSig(int code) {
        return code / 6 % 2;
    }

    static int ls(int code) {
        return code / 2 % 3;
    }

    static boolean gotCoffee(int code) {
        return code % 2 == 1;
    }
}
