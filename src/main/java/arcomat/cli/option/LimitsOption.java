package arcomat.cli.option;

import arcomat.sim.device.Limits;

import picocli.CommandLine.Option;

/** Whether simulated bricks have the limits of real ones. */
public final class LimitsOption {
    @Option(
            names = "--no-limits",
            description =
                    "Run on an ideal brick, which computes in no time and has room for everything:"
                            + " without the real one's heap, calls, speed, keys and packets.")
    private boolean off;

    public Limits limits() {
        return off ? Limits.NONE : Limits.OF_THE_BRICK;
    }
}
