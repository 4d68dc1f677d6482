package arcomat.analysis.search.product;

import arcomat.analysis.search.encoding.InclusionBits;
import arcomat.analysis.search.encoding.StateWords;
import arcomat.analysis.search.packed.NetworkTables.TooLarge;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.InductiveInvariant;
import arcomat.analysis.symbolic.InvariantGap;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Verifies a certificate of clauses, without any search: no run begins in what is never so, no step
 * leads there from elsewhere, and the right side follows each step from elsewhere. Knows what parts
 * do, and nothing of how the clauses were found.
 */
public final class ClauseCheck {
    private final InclusionBits bits;
    private final StateWords words;
    private final Runnable between;

    private ClauseCheck(InclusionBits bits, Runnable between) {
        this.bits = bits;
        this.words = bits.words().get();
        this.between = between;
    }

    /** What a clause is no clause for. */
    private static final class Unreadable extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Unreadable(String text) {
            super(text, null, false, false);
        }
    }

    /**
     * What is missing; empty for a proof.
     *
     * @param between called on the way; may throw to give up
     */
    public static Optional<String> problem(
            NetworkSystem left,
            TransitionSystem right,
            OutputCubes outputs,
            Certificate certificate,
            Runnable between) {
        try {
            InclusionBits bits = InclusionBits.of(left, right, outputs);
            return new ClauseCheck(bits, between).problem(certificate);
        } catch (CannotPack | TooLarge unfit) {
            return Optional.of("clauses cannot be checked here: " + unfit.getMessage());
        } catch (Unreadable clause) {
            return Optional.ofNullable(clause.getMessage());
        }
    }

    private Optional<String> problem(Certificate certificate) {
        List<int[]> excluded = new ArrayList<>(bits.granted());
        for (Entry entry : certificate.entries()) {
            between.run();
            excluded.add(cube(entry));
        }
        return new InductiveInvariant(excluded)
                .gap(bits.relation(), between)
                .map(gap -> gap.match(new Told(words)));
    }

    private int[] cube(Entry entry) {
        if (!entry.left().equals(Certificate.NEVER)) {
            throw new Unreadable(
                    "'%s' is no clause: these begin with 'never'".formatted(entry.left()));
        }
        return entry.right().stream().mapToInt(this::literal).toArray();
    }

    private int literal(String word) {
        OptionalInt literal = words.literal(word);
        if (literal.isEmpty()) {
            List<String> others = words.others(word);
            throw new Unreadable(
                    "'%s' is nothing that may be so%s"
                            .formatted(
                                    word,
                                    others.isEmpty() ? "" : ", as " + String.join(", ", others)));
        }
        return literal.getAsInt();
    }

    /** What is wrong, in words. */
    private record Told(StateWords words) implements InvariantGap.Cases<String> {
        @Override
        public String begins(InvariantGap.Begins gap) {
            return "a run begins in (%s), which is in what is never so: %s"
                    .formatted(words.state(gap.state()), all(gap.cube()));
        }

        @Override
        public String leads(InvariantGap.Leads gap) {
            return "%s leads to (%s), which is in what is never so: %s"
                    .formatted(
                            step(gap.state(), gap.inputs()),
                            words.state(gap.next()),
                            all(gap.cube()));
        }

        @Override
        public String bad(InvariantGap.Bad gap) {
            return step(gap.state(), gap.inputs()) + " is forbidden";
        }

        @Override
        public String inconclusive() {
            return "the conclusions of a solver do not follow";
        }

        private String step(boolean[] state, boolean[] inputs) {
            String from = words.state(state);
            String letter = words.input(inputs);
            return "a step"
                    + (from.isEmpty() ? "" : " out of (" + from + ")")
                    + (letter.isEmpty() ? "" : " with " + letter);
        }

        private String all(int[] cube) {
            return IntStream.of(cube).mapToObj(words::of).collect(Collectors.joining(", "));
        }
    }
}
