package arcomat.diagram;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.DISTANCE;
import static arcomat.semantics.ComponentBuilder.MOTOR;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.semantics.ComponentBuilder;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** Components of any shape, by number: the same number gives the same component. */
final class RandomModels {
    private static final List<Type> TYPES = List.of(BOOLEAN, DISTANCE, MOTOR);
    private static final List<String> NAMES =
            List.of("a", "stop", "leftLight", "emergencySwitchOfTheRobot", "Größe", "線", "W");

    private final Random random;

    private RandomModels(long seed) {
        random = new Random(seed);
    }

    /** Parts in parts, wired at random; ports may stay open, and send to several. */
    static Component composite(long seed) {
        RandomModels models = new RandomModels(seed);
        return models.composite("Whole", 1 + models.random.nextInt(3));
    }

    private Component composite(String name, int depth) {
        ComponentBuilder builder = ports(name);
        int parts = 1 + random.nextInt(6);
        List<String> senders = new ArrayList<>();
        List<String> receivers = new ArrayList<>();
        for (int i = 0; i < parts; i++) {
            String part = NAMES.get(random.nextInt(NAMES.size())) + i;
            boolean open = depth > 1 && random.nextInt(3) == 0;
            Component component =
                    open ? composite("Inner" + i, depth - 1) : ports("Leaf" + i).build();
            builder.part(part, component);
            component.outputs().forEach(port -> senders.add(part + "." + port.name()));
            component.inputs().forEach(port -> receivers.add(part + "." + port.name()));
        }
        Component interfaceOnly = builder.build();
        interfaceOnly.inputs().forEach(port -> senders.add(port.name()));
        interfaceOnly.outputs().forEach(port -> receivers.add(port.name()));
        for (String receiver : receivers) {
            if (!senders.isEmpty() && random.nextInt(5) > 0) {
                builder.connect(senders.get(random.nextInt(senders.size())), receiver);
            }
        }
        return builder.build();
    }

    private ComponentBuilder ports(String name) {
        ComponentBuilder builder = ComponentBuilder.component(name);
        for (int i = random.nextInt(5); i > 0; i--) {
            Type type = TYPES.get(random.nextInt(TYPES.size()));
            String port = NAMES.get(random.nextInt(NAMES.size())) + "P" + i;
            switch (random.nextInt(3)) {
                case 0 -> builder.in(type, port);
                case 1 -> builder.out(type, port);
                default -> builder.instantOut(type, port);
            }
        }
        return builder;
    }

    /** Up to a dozen states, with loops, parallel transitions, islands and several beginnings. */
    static Component automaton(long seed) {
        return new RandomModels(seed).automaton();
    }

    private Component automaton() {
        int count = 1 + random.nextInt(12);
        String[] states =
                IntStream.range(0, count)
                        .mapToObj(i -> NAMES.get(random.nextInt(NAMES.size())) + i)
                        .toArray(String[]::new);
        ComponentBuilder.AutomatonBuilder automaton =
                ComponentBuilder.component("Random")
                        .in(DISTANCE, "front")
                        .in(BOOLEAN, "gotCoffeeOrTeaOrWater")
                        .out(MOTOR, "cmd")
                        .out(BOOLEAN, "somethingWithALongName")
                        .automaton(Completion.IGNORE, states);
        for (int i = random.nextInt(3); i >= 0; i--) {
            automaton.initial(any(states), output());
        }
        for (int i = random.nextInt(2 * count + 2); i > 0; i--) {
            automaton.on(any(states) + " -> " + any(states), input(), output());
        }
        return automaton.build();
    }

    private String any(String... choices) {
        return choices[random.nextInt(choices.length)];
    }

    private String input() {
        return any(
                "",
                "front = clear",
                "front = ?, gotCoffeeOrTeaOrWater = true",
                "gotCoffeeOrTeaOrWater = true|false, front = clear|tooClose");
    }

    private String output() {
        return any("", "cmd = fwd", "cmd = stop|backRight", "cmd = --, somethingWithALongName = ?");
    }
}
