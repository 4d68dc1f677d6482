package arcomat.simulate.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.Choice;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** Lets an execution run over letters, given or drawn. */
public final class Simulation {
    private Simulation() {}

    /**
     * Performs a step per letter. Where the model goes wrong the trace ends and says why.
     *
     * @param execution that has not stepped yet
     */
    public static Trace run(Execution execution, List<Letter> letters) {
        List<Trace.Step> steps = new ArrayList<>(letters.size());
        return run(execution, letters.iterator(), steps::add).with(steps);
    }

    /**
     * Performs a step per letter, without keeping them.
     *
     * @param execution that has not stepped yet
     * @param seen is shown each step, and says whether to go on
     * @return what there is to say of the run besides its steps
     */
    public static Trace run(
            Execution execution, Iterator<Letter> letters, Predicate<Trace.Step> seen) {
        Optional<String> failure = Optional.empty();
        boolean wanted = true;
        while (wanted && failure.isEmpty() && letters.hasNext()) {
            try {
                wanted = seen.test(execution.step(letters.next()));
            } catch (ModelError error) {
                failure = Optional.of(String.valueOf(error.getMessage()));
            }
        }
        return new Trace(
                execution.component(), List.of(), failure, execution.opening(), execution.end());
    }

    /**
     * Letters at random over the external inputs of a network, platform components included: in a
     * slice a port carries a message with the given chance, and always if it is total; in the
     * event-driven profile a letter is one event, and now and then a latched port changes. They are
     * drawn one after the other as they are asked for, without an end. The seed may be that of the
     * run's choices: letters are drawn independently of them.
     *
     * @param chance of a message on a port in a slice, in percent
     */
    public static Stream<Letter> drawn(Network network, int seed, int chance) {
        Choice generator = new Choice(~seed);
        boolean timed = network.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        return Stream.generate(
                () -> timed ? slice(network, generator, chance) : event(network, generator));
    }

    private static Letter slice(Network network, Choice generator, int chance) {
        Map<String, Value> messages = new LinkedHashMap<>();
        for (Network.External input : network.inputs()) {
            if (input.port().total() || generator.next(100) < chance) {
                messages.put(input.name(), RandomValues.draw(input.port().type(), generator));
            }
        }
        return Letter.of(messages);
    }

    private static Letter event(Network network, Choice generator) {
        if (network.inputs().isEmpty()) {
            return Letter.SILENCE;
        }
        int chosen = generator.next(network.inputs().size());
        Network.External input = network.inputs().get(chosen);
        return Letter.of(Map.of(input.name(), RandomValues.draw(input.port().type(), generator)));
    }
}
