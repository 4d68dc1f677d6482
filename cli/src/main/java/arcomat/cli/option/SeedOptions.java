package arcomat.cli.option;

import arcomat.pipeline.WrongUse;
import arcomat.world.Physics;
import arcomat.world.Seeds;

import picocli.CommandLine.Option;

import java.math.BigDecimal;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Of commands that run worlds: what is drawn in them. */
public final class SeedOptions {
    /** Up to a hundredth of a second, which is a step of the world. */
    private static final Pattern CHANGE =
            Pattern.compile("(\\d{1,5}(?:\\.\\d\\d?)?)=(-?\\d{1,18})");

    private static final BigDecimal STEPS_PER_SECOND = BigDecimal.valueOf(1000 / Physics.STEP);

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Of what is drawn: noise, offsets of sensors, where robots really stand;"
                            + " default 1. The same seed gives the same run.")
    private long first;

    @Option(
            names = "--then",
            paramLabel = "SECONDS=N",
            description =
                    "From this moment on, another seed draws the noise of sensors; may be given"
                            + " several times. Before it, the run is the same.")
    private List<String> changes = List.of();

    public long first() {
        return first;
    }

    /** Whether one seed draws everything. */
    public boolean isSingle() {
        return changes.isEmpty();
    }

    /** All of them, in the order of time. */
    public Seeds seeds() throws WrongUse {
        Seeds seeds = Seeds.of(first);
        long last = -1;
        for (String change : changes) {
            Matcher matcher = CHANGE.matcher(change);
            if (!matcher.matches()) {
                throw new WrongUse("--then %s is not SECONDS=SEED, such as 12.5=77", change);
            }
            BigDecimal seconds = new BigDecimal(matcher.group(1));
            long tick = seconds.multiply(STEPS_PER_SECOND).longValueExact();
            if (tick <= last) {
                throw new WrongUse("--then %s is not later than the one before", change);
            }
            seeds = seeds.then(tick, Long.parseLong(matcher.group(2)));
            last = tick;
        }
        return seeds;
    }

    /** The seeds as a person reads them: {@code seed 5, then 12.5=77}. */
    public String shown() {
        StringBuilder shown = new StringBuilder("seed " + first);
        changes.forEach(change -> shown.append(", then ").append(change));
        return shown.toString();
    }
}
