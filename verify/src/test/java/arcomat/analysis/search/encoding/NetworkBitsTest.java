package arcomat.analysis.search.encoding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.packed.NetworkTables;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.symbolic.CheckedSolver;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Each step that a network takes is one of its clauses. Were one missing, what it leads to would
 * not be looked at, and something might be said to hold that does not.
 */
class NetworkBitsTest {
    private static final int NETWORKS = Integer.getInteger("symbolic.networks", 100);
    private static final int SEED = Integer.getInteger("symbolic.seed", 17);
    private static final int MOST_CONFIGURATIONS = 60;
    private static final int MOST_VALUES = 64;
    private static final int MOST_RULES = 20_000;

    /** A step, with the number of each message that comes. */
    private record Step(int from, int[] letter, int to, @Nullable Output shown) {}

    private int steps;
    private int ends;

    @Test
    void allStepsOfNetworksAreThere() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < NETWORKS; i++) {
            RandomNetworks.Plan plan = networks.plan();
            allStepsAreThere(plan.component("Whole"), plan.toString());
        }
        assertThat(steps).isGreaterThan(NETWORKS * 20);
        assertThat(ends).isGreaterThan(NETWORKS / 5);
    }

    private void allStepsAreThere(Component whole, String text) {
        List<String> outputs = whole.outputs().stream().map(Port::name).toList();
        Budget budget = new Budget(() -> false, 10_000);
        OutputCubes cubes = new OutputCubes();
        NetworkSystem system = NetworkSystem.of(whole, List.of(), outputs, cubes, budget);
        AllLetters letters = AllLetters.of(system);
        List<Integer> met = new ArrayList<>();
        List<Step> seen = explored(system, cubes, letters, met);
        try {
            int[] states = met.stream().mapToInt(Integer::intValue).toArray();
            NetworkTables tables =
                    system.tables(letters.messages(), states, MOST_VALUES, MOST_RULES);
            int[] shown = system.outputSignals();
            CheckedSolver solver = new CheckedSolver(() -> {});
            NetworkBits bits = new NetworkBits(tables, solver.clauses());
            for (Step step : seen) {
                int[] told = literals(step, system, bits, tables, met, shown);
                assertThat(solver.solveWith(told)).as("%s%n%s", text, step).isTrue();
            }
            steps += seen.size();
            ends += (int) seen.stream().filter(step -> step.to < 0).count();
        } catch (CannotPack | NetworkTables.TooLarge unfit) {
            return; // then the engine is not asked
        }
    }

    /**
     * @param met told the configurations that are met
     */
    private static List<Step> explored(
            NetworkSystem system, OutputCubes cubes, AllLetters letters, List<Integer> met) {
        IntStream.of(system.openings().next()).distinct().forEach(met::add);
        List<Step> steps = new ArrayList<>();
        for (int i = 0; i < met.size(); i++) {
            int from = met.get(i);
            letters.each(
                    letter -> {
                        Steps possible = system.steps(from, letters.values(letter));
                        for (int step = 0; step < possible.size(); step++) {
                            int next = possible.next()[step];
                            int output = possible.outputs()[step];
                            if (system.state(next).isError()) {
                                steps.add(new Step(from, letter.clone(), -1, null));
                            } else if (met.contains(next) || met.size() < MOST_CONFIGURATIONS) {
                                if (!met.contains(next)) {
                                    met.add(next);
                                }
                                Output shown = cubes.cube(output);
                                steps.add(new Step(from, letter.clone(), next, shown));
                            }
                        }
                    });
        }
        return steps;
    }

    /** All that a step says. */
    private static int[] literals(
            Step step,
            NetworkSystem system,
            NetworkBits bits,
            NetworkTables tables,
            List<Integer> met,
            int[] shown) {
        IntArrayList told = new IntArrayList();
        tell(told, bits.state(), bits.truths(tables.initial().get(met.indexOf(step.from))));
        for (int port = 0; port < step.letter.length; port++) {
            told.add(bits.sent(system.inputSignals()[port])[step.letter[port]]);
        }
        if (step.to < 0) {
            told.add(bits.end());
            return told.toArray();
        }
        told.add(-bits.end());
        tell(told, bits.next(), bits.truths(tables.initial().get(met.indexOf(step.to))));
        for (int port = 0; port < shown.length && step.shown != null; port++) {
            if (shown[port] >= 0 && step.shown.ports().get(port) instanceof Sent.Messages one) {
                int message = tables.messages().get(shown[port]).indexOf(one);
                told.add(bits.sent(shown[port])[message]);
            }
        }
        return told.toArray();
    }

    private static void tell(IntArrayList told, int[] variables, boolean[] truths) {
        for (int i = 0; i < variables.length; i++) {
            told.add(truths[i] ? variables[i] : -variables[i]);
        }
    }
}
