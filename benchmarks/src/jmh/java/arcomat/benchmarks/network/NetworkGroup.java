package arcomat.benchmarks.network;

import arcomat.benchmarks.measure.Allocation;
import arcomat.benchmarks.measure.Alternation;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Many small components. */
public final class NetworkGroup implements Group {
    private static final List<String> SHAPES = List.of("1x1000", "100x10");

    @Override
    public String name() {
        return "network";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(NetworkBenchmark.class, NetworkGrowthBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        List<String> found = new ArrayList<>();
        int[] messages = Messages.draw();
        for (String shape : SHAPES) {
            found.add(agreement(Shape.parse(shape)));
            Network network = Networks.of("generated", Shape.parse(shape));
            found.add(Allocation.perRun(500, Messages.COUNT, () -> network.run(messages)));
            found.add(inTurn(shape));
        }
        return found;
    }

    private static String inTurn(String shape) {
        int[] messages = Messages.draw();
        int[] sink = new int[1];
        Map<String, Runnable> contestants = new LinkedHashMap<>();
        for (String contestant : List.of("generated", "objects", "arrays")) {
            Network network = Networks.of(contestant, Shape.parse(shape));
            contestants.put(contestant, () -> sink[0] += network.run(messages));
        }
        long operations = (long) Messages.COUNT * Shape.parse(shape).parts();
        return Alternation.of(shape, contestants, operations);
    }

    /** Long enough for every message to reach the end of its chain. */
    private static String agreement(Shape shape) {
        int[] messages = Messages.draw();
        Network reference = Networks.of("objects", shape);
        List<Network> others = new ArrayList<>();
        for (String contestant : List.of("generated", "shuffled", "arrays")) {
            others.add(Networks.of(contestant, shape));
        }
        int checksum = 0;
        for (int i = 0; i <= 2 * shape.length() / Messages.COUNT; i++) {
            checksum = reference.run(messages);
            for (Network other : others) {
                if (other.run(messages) != checksum) {
                    throw new IllegalStateException("networks disagree: " + shape);
                }
            }
        }
        return "outputs agree for " + shape + ", checksum " + checksum;
    }

    @Override
    public List<Goal> goals() {
        List<Goal> goals = new ArrayList<>();
        for (String shape : SHAPES) {
            String us = "network generated " + shape;
            goals.add(
                    Goal.promise(shape + ", against objects", us, "network objects " + shape, 1.3));
            goals.add(Goal.aim(shape + ", against arrays", us, "network arrays " + shape, 2));
            goals.add(
                    Goal.promise(
                            shape + ", declared in no order",
                            "network shuffled " + shape,
                            us,
                            1.1));
        }
        goals.add(growth("1x1000", 0.01));
        goals.add(growth("1x100000", 0.0001));
        return goals;
    }

    private static Goal growth(String shape, double factor) {
        return Goal.promise(
                        "cost per part, " + shape + " against 1x10",
                        "growth generated " + shape,
                        "growth generated 1x10",
                        1.3)
                .times(factor);
    }
}
