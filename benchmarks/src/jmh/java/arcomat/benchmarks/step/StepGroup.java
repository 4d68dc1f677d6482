package arcomat.benchmarks.step;

import arcomat.benchmarks.measure.Allocation;
import arcomat.benchmarks.measure.Alternation;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import coffee.fig6.logic.AvoidCrash;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** One atomic component. */
public final class StepGroup implements Group {
    @Override
    public String name() {
        return "step";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(StepBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        List<String> found = new ArrayList<>();
        for (double density : new double[] {0.9, 0.05}) {
            found.add(agreement(density));
            found.add(inTurn(density));
        }
        AvoidCrash machine = new AvoidCrash();
        Letters letters = new Letters(0.9);
        found.add(Allocation.perRun(1000, Letters.COUNT, () -> Contestants.run(machine, letters)));
        return found;
    }

    private static String inTurn(double density) {
        Letters letters = new Letters(density);
        EnumLetters enumLetters = new EnumLetters(letters);
        AvoidCrash generated = new AvoidCrash();
        IntSwitch intSwitch = new IntSwitch();
        EnumSwitch enumSwitch = new EnumSwitch();
        int[] sink = new int[1];
        Map<String, Runnable> contestants = new LinkedHashMap<>();
        contestants.put("generated", () -> sink[0] += Contestants.run(generated, letters));
        contestants.put("intSwitch", () -> sink[0] += Contestants.run(intSwitch, letters));
        contestants.put("enumSwitch", () -> sink[0] += Contestants.run(enumSwitch, enumLetters));
        return Alternation.of("step at " + density, contestants, Letters.COUNT);
    }

    private static String agreement(double density) {
        Letters letters = new Letters(density);
        int wanted = Contestants.ALL.get("intSwitch").applyAsInt(letters);
        Contestants.ALL.forEach(
                (name, run) -> {
                    int actual = run.applyAsInt(letters);
                    if (actual != wanted) {
                        throw new IllegalStateException(
                                name + " sends something else at density " + density);
                    }
                });
        return "outputs agree at density " + density + ", checksum " + wanted;
    }

    @Override
    public List<Goal> goals() {
        List<Goal> goals = new ArrayList<>();
        for (String density : List.of("0.9", "0.05")) {
            String us = "generated " + density;
            goals.add(
                    Goal.promise(
                            "step at " + density + ", against a switch over int fields",
                            us,
                            "intSwitch " + density,
                            1.1));
            goals.add(
                    Goal.promise(
                            "step at " + density + ", against a switch over enum fields",
                            us,
                            "enumSwitch " + density,
                            0.6));
        }
        return goals;
    }
}
