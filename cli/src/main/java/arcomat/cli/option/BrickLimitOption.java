package arcomat.cli.option;

import arcomat.sim.device.Limits;

import picocli.CommandLine.Option;

/** Of commands whose robots run on simulated bricks. */
public final class BrickLimitOption {
    @Option(
            names = "--no-limits",
            description =
                    "Run on an ideal brick, which computes in no time and has room for everything:"
                            + " without the real one's heap, calls, speed, keys and packets.")
    private boolean ideal;

    /** Those of the bricks that programs meet. */
    public Limits limits() {
        return ideal ? Limits.NONE : Limits.OF_THE_BRICK;
    }

    /** Whether it was given. */
    public boolean isGiven() {
        return ideal;
    }
}
