package arcomat.analysis;

import arcomat.analysis.Draft.Opening;
import arcomat.analysis.Draft.Socket;
import arcomat.analysis.NaiveComposition.Move;
import arcomat.analysis.NaiveComposition.State;
import arcomat.analysis.Sketch.Edge;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Small compositions, wired at random, beside atomic components: those are made from what the
 * composition does, and then edited, or arbitrary. The same seed gives the same questions.
 */
public final class RandomNetworks {
    private static final int MOST_STATES = 40;

    private final Random random;

    public RandomNetworks(long seed) {
        random = new Random(seed);
    }

    /** Two promises, and how they came about. */
    public record Question(Promise left, Promise right, String text) {}

    record Connection(String sender, String receiver) {}

    /** A composition of drafts. */
    public record Plan(List<Socket> sockets, List<Draft> parts, List<Connection> connections) {
        public Component component(String name) {
            ComponentBuilder builder = ComponentBuilder.component(name);
            sockets.forEach(socket -> socket.add(builder));
            for (int i = 0; i < parts.size(); i++) {
                builder.part("p" + i, parts.get(i).component(name + "Part" + i));
            }
            connections.forEach(each -> builder.connect(each.sender, each.receiver));
            return builder.build();
        }

        public Plan withPart(int position, Draft part) {
            List<Draft> changed = new ArrayList<>(parts);
            changed.set(position, part);
            return new Plan(sockets, changed, connections);
        }
    }

    /** A composition without a circle of messages that have no delay. */
    public Plan plan() {
        while (true) {
            Plan plan = wired();
            try {
                new NaiveComposition(plan.component("Whole"), List.of());
                return plan;
            } catch (IllegalArgumentException circle) {
                continue;
            }
        }
    }

    private Plan wired() {
        boolean total = random.nextInt(4) == 0;
        List<Socket> sockets = new ArrayList<>();
        sockets.add(new Socket("a", true, total, 0));
        if (random.nextInt(3) == 0) {
            sockets.add(new Socket("b", true, false, 0));
        }
        List<Draft> parts = new ArrayList<>();
        int count = 2 + random.nextInt(2);
        for (int i = 0; i < count; i++) {
            parts.add(draft(ports(), 2 + random.nextInt(3)));
        }
        List<String> senders = new ArrayList<>(sockets.stream().map(Socket::name).toList());
        List<String> parting = new ArrayList<>();
        List<Connection> connections = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            for (Socket output : parts.get(i).outputs()) {
                parting.add("p" + i + "." + output.name());
            }
        }
        senders.addAll(parting);
        for (int i = 0; i < count; i++) {
            for (Socket input : parts.get(i).inputs()) {
                if (random.nextInt(10) > 0) {
                    String sender = i == 0 && input.name().equals("x") ? "a" : any(senders);
                    connections.add(new Connection(sender, "p" + i + "." + input.name()));
                }
            }
        }
        for (String output : random.nextInt(3) == 0 ? List.of("o", "r") : List.of("o")) {
            sockets.add(new Socket(output, false, false, 1));
            List<String> possible = random.nextInt(12) == 0 ? senders : parting;
            connections.add(new Connection(any(possible), output));
        }
        return new Plan(sockets, parts, connections);
    }

    private <T> T any(List<T> list) {
        return list.get(random.nextInt(list.size()));
    }

    /** One or two inputs, one or two outputs. */
    private List<Socket> ports() {
        List<Socket> sockets = new ArrayList<>();
        sockets.add(new Socket("x", true, false, 0));
        if (random.nextBoolean()) {
            sockets.add(new Socket("y", true, false, 0));
        }
        int delay = random.nextInt(3) == 0 ? 0 : 1;
        sockets.add(new Socket("u", false, delay == 1 && random.nextInt(5) == 0, delay));
        if (random.nextInt(3) == 0) {
            sockets.add(new Socket("v", false, false, random.nextInt(2)));
        }
        return sockets;
    }

    /** An arbitrary automaton; not every input is handled. */
    Draft draft(List<Socket> sockets, int states) {
        List<Socket> inputs = sockets.stream().filter(Socket::input).toList();
        List<Socket> outputs = sockets.stream().filter(each -> !each.input()).toList();
        boolean total = outputs.stream().anyMatch(Socket::total);
        Completion completion = completion(total);
        boolean free = random.nextInt(6) == 0;
        List<Edge> edges = new ArrayList<>();
        for (int state = 0; state < states; state++) {
            int count = 2 + random.nextInt(3);
            for (int i = 0; i < count; i++) {
                int target = random.nextInt(states);
                String input = i == 0 && random.nextInt(3) > 0 ? "" : input(inputs);
                edges.add(new Edge(state, target, input, output(outputs, free)));
            }
        }
        List<Opening> openings = new ArrayList<>();
        List<Socket> late = outputs.stream().filter(each -> each.delay() > 0).toList();
        openings.add(new Opening(0, output(late, free)));
        if (random.nextInt(6) == 0) {
            openings.add(new Opening(random.nextInt(states), output(late, free)));
        }
        return new Draft(sockets, completion, free, states, openings, edges);
    }

    /** An error on one side alone decides too much. */
    private Completion completion(boolean total) {
        Completion completion = Completion.values()[random.nextInt(4)];
        boolean rare = completion == Completion.ERROR && random.nextInt(3) > 0;
        return rare || total && completion == Completion.IGNORE ? Completion.OUTPUT : completion;
    }

    private String input(List<Socket> inputs) {
        List<String> items = new ArrayList<>();
        for (Socket socket : inputs) {
            int kind = random.nextInt(8);
            if (kind < 6) {
                String silence = socket.total() ? "?" : "--";
                items.add(
                        socket.name()
                                + " = "
                                + List.of("m", "m", "n", "n", "?", silence).get(kind));
            }
        }
        return String.join(", ", items);
    }

    private String output(List<Socket> outputs, boolean free) {
        List<String> items = new ArrayList<>();
        for (Socket socket : outputs) {
            int kind = random.nextInt(10);
            if (kind == 0) {
                items.add(socket.name() + " = ?");
            } else if (kind < 8 || socket.total()) {
                items.add(socket.name() + " = " + any(Draft.MESSAGES));
            } else if (free && kind == 8) {
                items.add(socket.name() + " = --");
            }
        }
        return String.join(", ", items);
    }

    /** A composition and an atomic component, either way round, or two compositions. */
    public Question question() {
        Plan plan = plan();
        Component whole = plan.component("Whole");
        return switch (random.nextInt(5)) {
            case 0 -> {
                Draft atom = beside(plan, whole);
                String text = atom + " against " + plan;
                yield new Question(promise(atom.component("Atom")), promise(whole), text);
            }
            case 1 -> {
                Plan other = edited(plan);
                String text = plan + " against " + other;
                yield new Question(promise(whole), promise(other.component("Other")), text);
            }
            default -> {
                Draft atom = beside(plan, whole);
                String text = plan + " against " + atom;
                yield new Question(promise(whole), promise(atom.component("Atom")), text);
            }
        };
    }

    private Plan edited(Plan plan) {
        int position = random.nextInt(plan.parts().size());
        Draft part = plan.parts().get(position);
        for (int edits = 1 + random.nextInt(3); edits > 0; edits--) {
            part = part.edited(random);
        }
        return plan.withPart(position, part);
    }

    private static Promise promise(Component component) {
        return Promise.of(component, List.of());
    }

    /** What the composition does, edited now and then, or something arbitrary. */
    private Draft beside(Plan plan, Component whole) {
        Optional<Draft> flat =
                random.nextInt(12) == 0
                        ? Optional.empty()
                        : flattened(plan, new NaiveComposition(whole, List.of()));
        if (flat.isEmpty()) {
            return draft(plan.sockets(), 1 + random.nextInt(3));
        }
        Draft draft = flat.get();
        for (int edits = random.nextInt(4); edits > 0; edits--) {
            draft = draft.edited(random);
        }
        return draft;
    }

    /** One automaton that does what a composition does; none where it has many states. */
    private Optional<Draft> flattened(Plan plan, NaiveComposition whole) {
        Map<State, Integer> numbers = new HashMap<>();
        List<State> states = new ArrayList<>();
        List<Edge> edges = new ArrayList<>();
        List<Opening> openings = new ArrayList<>();
        for (Move start : whole.starts()) {
            openings.add(new Opening(number(start.next(), numbers, states), block(start.output())));
        }
        boolean errors = false;
        for (int state = 0; state < states.size(); state++) {
            if (states.size() > MOST_STATES) {
                return Optional.empty();
            }
            for (Map<String, Value> input : NaiveInclusion.letters(whole.component().inputs())) {
                for (Move move : whole.moves(states.get(state), input)) {
                    if (move.output() == NaiveMachine.ERROR) {
                        errors = true;
                        continue;
                    }
                    int target = number(move.next(), numbers, states);
                    edges.add(new Edge(state, target, letter(input), block(move.output())));
                }
            }
        }
        Completion completion = errors ? Completion.ERROR : Completion.values()[random.nextInt(4)];
        List<Socket> sockets = random.nextInt(5) == 0 ? plan.sockets() : alike(plan, whole);
        return Optional.of(new Draft(sockets, completion, false, states.size(), openings, edges));
    }

    /** Sends with delay where the composition does. */
    private static List<Socket> alike(Plan plan, NaiveComposition whole) {
        return plan.sockets().stream()
                .map(s -> s.input() || whole.isDelayed(s.name()) ? s : s.withDelay(0))
                .toList();
    }

    private static int number(State state, Map<State, Integer> numbers, List<State> states) {
        return numbers.computeIfAbsent(
                state,
                each -> {
                    states.add(each);
                    return states.size() - 1;
                });
    }

    private static String letter(Map<String, Value> letter) {
        return letter.entrySet().stream()
                .map(
                        each ->
                                each.getKey()
                                        + " = "
                                        + (each.getValue() == null ? "--" : each.getValue()))
                .collect(Collectors.joining(", "));
    }

    private static String block(Map<String, Value> output) {
        return output.entrySet().stream()
                .filter(each -> each.getValue() != null)
                .map(each -> each.getKey() + " = " + each.getValue())
                .collect(Collectors.joining(", "));
    }
}
