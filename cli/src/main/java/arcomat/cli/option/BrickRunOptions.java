package arcomat.cli.option;

import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.sim.device.Limits;
import arcomat.sim.time.OutOfPatience;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

import java.time.Duration;

/** Of commands that run simulated bricks. */
public final class BrickRunOptions {
    @Mixin private BrickLimitOption brick = new BrickLimitOption();

    @Option(
            names = "--timeout",
            paramLabel = "SECONDS",
            defaultValue = "300",
            converter = SecondsReader.class,
            description =
                    "Give up a run that takes longer, by the PC's clock; default 300. It is then"
                            + " unknown how it ends.")
    private Duration patience;

    /** Those of the bricks that programs meet. */
    public Limits limits() {
        return brick.limits();
    }

    /** How long bricks may keep the PC busy: a program may compute without an end. */
    public Duration patience() {
        return patience;
    }

    /** Tells of a run that was given up, and returns the exit status that says so. */
    public static int gaveUp(OutOfPatience reason, Console console) {
        console.err().println("given up: " + reason.getMessage() + "; --timeout gives it more");
        return ExitStatus.UNKNOWN;
    }
}
