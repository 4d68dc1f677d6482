package arcomat.analysis.symbolic;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** The solver says the same as trying all ways, and its refutations can be followed. */
class SatSolverTest {
    private static final int FORMULAS = 300;
    private static final int FEW = 9;

    @Tag("slow")
    @Test
    void saysTheSameAsTryingAllWays() {
        Random random = new Random(5);
        int satisfied = 0;
        for (int i = 0; i < FORMULAS; i++) {
            int variables = 3 + random.nextInt(FEW - 2);
            Clauses clauses = clauses(random, variables, (int) (variables * 3.4));
            SatSolver solver = clauses.into(new SatSolver());
            for (int question = 0; question < 3; question++) {
                int[] assumed =
                        IntStream.range(0, 1 + random.nextInt(3))
                                .map(j -> literal(random, variables))
                                .toArray();
                boolean possible = isPossible(clauses, assumed);
                assertThat(solver.solve(assumed)).isEqualTo(possible);
                satisfied += possible ? 1 : 0;
                if (possible) {
                    assertSatisfied(clauses, solver, assumed);
                } else {
                    int[] core = solver.core();
                    assertThat(Arrays.stream(core)).allMatch(each -> isAmong(each, assumed));
                    assertThat(isPossible(clauses, core)).isFalse();
                }
            }
        }
        assertThat(satisfied).isBetween(FORMULAS / 2, 5 * FORMULAS / 2);
    }

    @Test
    void refutesInStepsThatFollow() {
        Random random = new Random(6);
        int refuted = 0;
        for (int i = 0; i < FORMULAS / 2; i++) {
            Clauses clauses = clauses(random, 40, 190);
            List<int[]> proof = new ArrayList<>();
            if (!clauses.into(new SatSolver(proof::add)).solve()) {
                refuted++;
                assertThat(new UnitPropagation().refutes(clauses, proof, () -> {})).isTrue();
            }
        }
        assertThat(refuted).isGreaterThan(FORMULAS / 8);
    }

    /** One more clause that does not follow, and the rest is no refutation any more. */
    @Test
    void believesNoStepThatDoesNotFollow() {
        Clauses clauses = new Clauses();
        int one = clauses.variable();
        int other = clauses.variable();
        clauses.add(one, other);
        List<int[]> wrong = List.of(new int[] {one}, new int[] {-one}, new int[0]);
        assertThat(new UnitPropagation().refutes(clauses, wrong, () -> {})).isFalse();
        clauses.add(one, -other);
        clauses.add(-one, other);
        assertThat(new UnitPropagation().refutes(clauses, wrong, () -> {})).isFalse();
        clauses.add(-one, -other);
        assertThat(new UnitPropagation().refutes(clauses, wrong, () -> {})).isTrue();
    }

    /** Nor that literals exclude each other where that does not follow; clauses may come later. */
    @Test
    void excludesWhatFollowsOnly() {
        Clauses clauses = new Clauses();
        int one = clauses.variable();
        int other = clauses.variable();
        clauses.add(-one, other);
        UnitPropagation check = new UnitPropagation();
        int[] both = {one, other};
        int[] contrary = {one, -other};
        assertThat(check.excludes(clauses, List.of(), contrary, () -> {})).isTrue();
        assertThat(check.excludes(clauses, List.of(), both, () -> {})).isFalse();
        List<int[]> conclusions = List.of(new int[] {-one});
        assertThat(check.excludes(clauses, conclusions, both, () -> {})).isFalse();
        int third = clauses.variable();
        clauses.add(-one, -other, third);
        clauses.add(-one, -third);
        assertThat(check.excludes(clauses, conclusions, both, () -> {})).isTrue();
    }

    private static Clauses clauses(Random random, int variables, int count) {
        Clauses clauses = new Clauses();
        for (int i = 0; i < variables; i++) {
            clauses.variable();
        }
        for (int i = 0; i < count; i++) {
            int length = random.nextInt(8) == 0 ? 2 : 3;
            clauses.add(IntStream.range(0, length).map(j -> literal(random, variables)).toArray());
        }
        return clauses;
    }

    private static int literal(Random random, int variables) {
        int variable = 1 + random.nextInt(variables);
        return random.nextBoolean() ? variable : -variable;
    }

    private static boolean isAmong(int literal, int[] all) {
        return Arrays.stream(all).anyMatch(each -> each == literal);
    }

    private static boolean isPossible(Clauses clauses, int[] assumed) {
        return IntStream.range(0, 1 << FEW + 2)
                .anyMatch(
                        way ->
                                Arrays.stream(assumed).allMatch(each -> isTrue(way, each))
                                        && clauses.all().stream()
                                                .allMatch(clause -> isTrue(way, clause)));
    }

    private static boolean isTrue(int way, int[] clause) {
        return Arrays.stream(clause).anyMatch(each -> isTrue(way, each));
    }

    private static boolean isTrue(int way, int literal) {
        return (way >> Math.abs(literal) & 1) == (literal > 0 ? 1 : 0);
    }

    private static void assertSatisfied(Clauses clauses, SatSolver solver, int[] assumed) {
        assertThat(Arrays.stream(assumed))
                .allMatch(each -> solver.isTrue(Math.abs(each)) == each > 0);
        assertThat(clauses.all())
                .allMatch(
                        clause ->
                                Arrays.stream(clause)
                                        .anyMatch(
                                                each -> solver.isTrue(Math.abs(each)) == each > 0));
    }
}
