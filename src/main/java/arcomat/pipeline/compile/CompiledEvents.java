package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Drives event-driven compiled code: one event and all that follows from it. It visits the
 * instances itself, in the order in which the generated network does, to see every reaction.
 */
final class CompiledEvents extends CompiledExecution.Engine {
    private final Network network;
    private final List<Waiter> waiters = new ArrayList<>();
    private final Map<String, Call> senders = new LinkedHashMap<>();
    private final Map<String, List<Value>> shown = new LinkedHashMap<>();
    private boolean started;
    private Optional<Letter> opening = Optional.empty();

    /** An instance with its queue. */
    private record Waiter(CompiledActor actor, Slot queued, int capacity, Call start, Call react) {}

    CompiledEvents(CompiledModel model, Network network, List<Value> arguments, int seed) {
        super(model, network, arguments, seed);
        this.network = network;
        List<CompiledActor> actors = CompiledActor.all(model, network, parts, messages);
        for (int i = 0; i < actors.size(); i++) {
            Component component = network.instances().get(i).component();
            Object instance = Objects.requireNonNull(parts.get(actors.get(i).path())).object();
            waiters.add(
                    new Waiter(
                            actors.get(i),
                            new Slot(instance, model.place(component).queued()),
                            component.queueCapacity(),
                            new Call(instance, "start", 0),
                            new Call(instance, "react", 0)));
        }
        network.inputs().forEach(this::connectInput);
        network.outputs().forEach(this::watchOutput);
    }

    private void connectInput(Network.External external) {
        CodeLayout.Place place = place(external);
        String method = Objects.requireNonNull(place.methods().get(external.port().name()));
        senders.put(external.name(), new Call(part(external).object(), method, 1));
    }

    private void watchOutput(Network.External external) {
        shown.put(external.name(), new ArrayList<>());
        Slot border = new Slot(part(external).object(), place(external).border());
        BorderRecorder recorder = (BorderRecorder) border.get();
        if (recorder == null) {
            recorder = new BorderRecorder(messages);
            border.set(recorder);
        }
        recorder.record(external.port(), Objects.requireNonNull(shown.get(external.name())));
    }

    private CodeLayout.Place place(Network.External external) {
        return model.place(part(external).component());
    }

    @Override
    Trace.Step step(Letter input, int number) {
        shown.values().forEach(List::clear);
        List<Trace.Activity> activities = new ArrayList<>();
        if (!started) {
            started = true;
            end = Optional.of(new Trace.End(input, Letter.SILENCE));
            waiters.forEach(waiter -> guarded(waiter, waiter.start));
            runToCompletion(activities);
            opening = Optional.of(new Letter(shown));
            end = Optional.empty();
        }
        surroundings.requireKnownPorts(input);
        end = Optional.of(new Trace.End(input, Letter.SILENCE));
        for (Network.External external : network.inputs()) {
            for (Value message : input.messages(external.name())) {
                Object held = messages.toJava(message, external.port().type());
                Call sender = Objects.requireNonNull(senders.get(external.name()));
                guarded(null, () -> sender.with(held));
            }
        }
        runToCompletion(activities);
        end = Optional.empty();
        return new Trace.Step(number, input, new Letter(shown), activities);
    }

    @Override
    Optional<Letter> opening() {
        return opening;
    }

    private void runToCompletion(List<Trace.Activity> activities) {
        int reactions = 0;
        boolean worked = true;
        while (worked) {
            worked = false;
            for (Waiter waiter : waiters) {
                if (waiter.queued.getInt() > 0) {
                    worked = true;
                    waiter.actor.begin();
                    guarded(waiter, waiter.react);
                    activities.add(waiter.actor.activity());
                    reactions++;
                }
            }
            if (reactions > Execution.MOST_REACTIONS) {
                throw Execution.circling();
            }
        }
    }

    /** Puts the path of the instance that went wrong before the message of an error. */
    private void guarded(@Nullable Waiter active, Runnable action) {
        try {
            action.run();
        } catch (ModelError problem) {
            Waiter culprit = active;
            for (Waiter waiter : waiters) {
                culprit = waiter.queued.getInt() > waiter.capacity ? waiter : culprit;
            }
            String path = culprit == null ? "" : culprit.actor.path();
            throw new ModelError((path.isEmpty() ? "" : path + ": ") + problem.getMessage());
        }
    }
}
