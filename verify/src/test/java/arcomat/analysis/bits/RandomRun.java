package arcomat.analysis.bits;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.refinement.Sides;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Runs of the left side on random messages, which the right one has to be able to follow. Only the
 * step relation is asked.
 */
public final class RandomRun {
    private static final int SLICES = 30;
    private static final int SILENT = 8;
    private static final double[] NOTABLE = {
        0,
        -0.0,
        0.5,
        1,
        0.1,
        2,
        1.5,
        10,
        3,
        -0.5,
        -1,
        1e17,
        0x1p31,
        0x1p53,
        Double.MIN_VALUE,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.NaN
    };

    private final ComponentSemantics side;
    private final Random random;
    private final List<Moment> moments = new ArrayList<>();

    private RandomRun(ComponentSemantics side, Random random) {
        this.side = side;
        this.random = random;
    }

    /** The right side follows what the left one does. */
    public static void follow(Sides sides, Random random, String about) {
        List<Moment> run = new RandomRun(sides.left().behaviour(), random).run();
        assertThat(Replay.possible(sides.right(), run))
                .as("%s%nfollows %s", about, run)
                .isEqualTo(run.size());
    }

    private List<Moment> run() {
        JointStart start = any(side.starts());
        add(Letter.SILENCE, start.output());
        List<Configuration> now = start.configurations();
        for (int slice = 0; slice < SLICES; slice++) {
            Letter letter = letter();
            Prospect prospect = side.prospect(now, Input.of(side.component(), letter));
            int all = prospect.reactions().size() + prospect.errors().size();
            int which = random.nextInt(all);
            if (which >= prospect.reactions().size()) {
                moments.add(new Moment(letter, Map.of(), "", List.of(), true));
                return moments;
            }
            JointReaction reaction = prospect.reactions().get(which);
            add(letter, reaction.output());
            now = reaction.next();
        }
        return moments;
    }

    private <T> T any(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }

    private void add(Letter letter, Output output) {
        Map<String, Sent> sent = new LinkedHashMap<>();
        List<Port> ports = side.component().outputs();
        for (int i = 0; i < ports.size(); i++) {
            sent.put(ports.get(i).name(), chosen(output.ports().get(i), ports.get(i).type()));
        }
        moments.add(new Moment(letter, sent, "", List.of()));
    }

    /** One of the messages that are left open. */
    private Sent chosen(Sent open, Type type) {
        if (open instanceof Sent.Messages) {
            return open;
        }
        return open.allows(List.of()) && random.nextBoolean()
                ? Sent.SILENCE
                : Sent.of(message(type));
    }

    private Letter letter() {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        for (Port port : side.component().inputs()) {
            if (port.total() || random.nextInt(SILENT) > 0) {
                messages.put(port.name(), List.of(message(port.type())));
            }
        }
        return new Letter(messages);
    }

    private Value message(Type type) {
        if (type instanceof Type.RealType) {
            return new Value.RealValue(real(random));
        }
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue(random.nextBoolean());
        }
        return type instanceof Type.StringType
                ? new Value.StringValue(random.nextBoolean() ? "a" : "b")
                : new Value.IntegerValue((int) real(random));
    }

    /** A number that matters, or one next to it, or any. */
    private static double real(Random random) {
        double number = NOTABLE[random.nextInt(NOTABLE.length)];
        return switch (random.nextInt(4)) {
            case 0 -> Double.longBitsToDouble(random.nextLong());
            case 1 -> random.nextBoolean() ? Math.nextUp(number) : Math.nextDown(number);
            default -> number;
        };
    }
}
