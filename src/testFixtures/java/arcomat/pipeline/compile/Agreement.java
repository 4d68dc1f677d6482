package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/** Runs a component interpreted and compiled over random words and compares every step. */
public final class Agreement {
    /** How often a patient word has the same letter in a row, on average. */
    private static final int REPETITIONS = 16;

    /** How many times as long as others a patient word is. */
    private static final int PATIENCE = 4;

    private final Component component;
    private final List<Value> arguments;
    private final Network network;
    private final Set<String> transitionsTaken = new HashSet<>();

    public Agreement(Component component, List<Value> arguments) {
        this.component = component;
        this.arguments = arguments;
        this.network = Network.of(component, arguments);
    }

    /**
     * Both ways to choose, so many random words of so many letters. Every other word is patient:
     * its letters are repeated, for models that wait.
     */
    public Agreement holds(int words, int letters) {
        for (Choosing choosing : Choosing.values()) {
            CompiledModel model = CompiledModel.of(component, choosing);
            for (int word = 0; word < words; word++) {
                compare(model, choosing, word, letters);
            }
        }
        return this;
    }

    /**
     * As above, with code that has been compiled with that of others.
     *
     * @param all has the component as a part
     */
    public Agreement holdsIn(CompiledModel all, int words, int letters) {
        CompiledModel model =
                new CompiledModel(component, all.choosing(), all.layout(), all.loader());
        for (int word = 0; word < words; word++) {
            compare(model, all.choosing(), word, letters);
        }
        return this;
    }

    /** Instance path and transition index of every transition that was taken. */
    public Set<String> transitionsTaken() {
        return transitionsTaken;
    }

    private void compare(CompiledModel model, Choosing choosing, int seed, int letters) {
        Choice choice = choosing == Choosing.FIRST ? Choice.first() : Choice.random(seed);
        Execution interpreted = new Interpreter(component, arguments, choice);
        Execution compiled = new CompiledExecution(model, arguments, seed);
        Random random = new Random(seed);
        boolean patient = seed % 2 == 1;
        Letter letter = letter(random);
        for (int i = 0; i < (patient ? letters * PATIENCE : letters); i++) {
            if (!patient || random.nextInt(REPETITIONS) == 0) {
                letter = letter(random);
            }
            Object expected = step(interpreted, letter);
            assertThat(step(compiled, letter))
                    .as("%s, %s, word %d, letter %d", component.name(), choosing, seed, i)
                    .isEqualTo(expected);
            if (expected instanceof String) {
                return;
            }
            note((Trace.Step) expected);
        }
    }

    private void note(Trace.Step step) {
        for (Trace.Activity activity : step.activities()) {
            if (activity.cause() instanceof Trace.Taken taken) {
                transitionsTaken.add(activity.instance() + "#" + taken.index());
            }
        }
    }

    /** A step, or the message of its error. */
    private static Object step(Execution execution, Letter letter) {
        try {
            return execution.step(letter);
        } catch (ModelError problem) {
            return problem.getMessage();
        }
    }

    private Letter letter(Random random) {
        Map<String, Value> messages = new LinkedHashMap<>();
        boolean timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        for (Network.External external : network.inputs()) {
            if (!timed && !messages.isEmpty()) {
                break;
            }
            if (external.port().total() || random.nextInt(3) > 0) {
                messages.put(external.name(), value(external.port().type(), random));
            }
        }
        return Letter.of(messages);
    }

    static Value value(Type type, Random random) {
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue(random.nextBoolean());
        }
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, random.nextInt(enumeration.constants().size()));
        }
        if (type instanceof Type.IntegerType integer) {
            long low = Math.max(integer.low(), -10);
            long high = Math.min(integer.high(), Math.max(low, 300));
            return new Value.IntegerValue(low + random.nextInt((int) (high - low + 1)));
        }
        if (type instanceof Type.ClassType object) {
            List<Value> attributes = new ArrayList<>();
            object.attributes().forEach(a -> attributes.add(value(a.type(), random)));
            return new Value.ObjectValue(object, attributes);
        }
        if (type instanceof Type.RealType real) {
            double drawn = random.nextInt(4000) / 1000.0 - 2;
            return new Value.RealValue(real.single() ? (float) drawn : drawn);
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue("ab*\n".charAt(random.nextInt(4)));
        }
        if (type instanceof Type.StringType) {
            return new Value.StringValue(List.of("", "a", "reading").get(random.nextInt(3)));
        }
        return type.first();
    }
}
