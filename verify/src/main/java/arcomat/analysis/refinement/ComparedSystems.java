package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.encoding.SymbolicInclusion;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.CertificateCheck;
import arcomat.analysis.search.product.ClauseCheck;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.AutomataSystem;
import arcomat.analysis.search.system.DelayedSystem;
import arcomat.analysis.search.system.DrivenSystem;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.ShiftedSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;
import arcomat.model.Port;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Both sides of a comparison, ready to be explored. Where only one of them sends with delay, they
 * are compared by what is seen.
 *
 * @param plainLeft the left one as it sends
 * @param plainRight the right one as it sends
 * @param left the left one as it is seen
 * @param right the right one as it is seen
 * @param observed the output ports that are compared
 */
public record ComparedSystems(
        TransitionSystem plainLeft,
        TransitionSystem plainRight,
        TransitionSystem left,
        TransitionSystem right,
        List<Port> observed,
        OutputCubes outputs) {

    private static ComparedSystems of(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs) {
        return new ComparedSystems(
                left,
                right,
                ShiftedSystem.beside(left, right, observed, outputs),
                ShiftedSystem.beside(right, left, observed, outputs),
                observed,
                outputs);
    }

    public static ComparedSystems of(Promise left, Promise right, Budget budget) {
        OutputCubes outputs = new OutputCubes();
        List<Port> observed = right.ports().stream().filter(port -> !port.isInput()).toList();
        List<String> names = observed.stream().map(Port::name).toList();
        return of(
                DrivenSystem.of(system(left, names, outputs, budget)),
                system(right, names, outputs, budget),
                observed,
                outputs);
    }

    private static TransitionSystem system(
            Promise promise, List<String> observed, OutputCubes outputs, Budget budget) {
        return promise.isComposition()
                ? NetworkSystem.of(
                        promise.component(), promise.arguments(), observed, outputs, budget)
                : new AutomataSystem(promise.behaviour(), observed, outputs, budget);
    }

    /** The same with a right side that is so many slices late. */
    ComparedSystems late(int slices, Budget budget) {
        TransitionSystem late =
                DelayedSystem.of(plainRight, slices, observed.size(), outputs, budget);
        return of(plainLeft, late, observed, outputs);
    }

    /** Compared ports on which only one of the sides sends with delay, by name. */
    List<String> shifted() {
        return Stream.of(left, right).flatMap(this::late).sorted().map(this::name).toList();
    }

    /** Compared ports on which one of the sides is seen later than it sends, by name. */
    static Set<String> late(Promise left, Promise right, boolean isLeft) {
        ComparedSystems sides = of(left, right, Budget.ofMemory());
        return sides.late(isLeft ? sides.left : sides.right)
                .map(sides::name)
                .collect(Collectors.toSet());
    }

    private Stream<Integer> late(TransitionSystem system) {
        return system instanceof ShiftedSystem shown ? shown.late().stream().boxed() : Stream.of();
    }

    private String name(int port) {
        return observed.get(port).name();
    }

    public TraceInclusion inclusion(Budget budget) {
        return new TraceInclusion(left, right, observed, outputs, budget);
    }

    /**
     * As above, with a second engine beside a long search.
     *
     * @param symbolic makes the systems that it is asked about: its own ones
     * @param stores makes places for packed pairs; empty for those in memory
     */
    TraceInclusion inclusion(
            Budget budget,
            Supplier<Optional<ComparedSystems>> symbolic,
            Optional<PairStore.Maker> stores) {
        return new TraceInclusion(
                left,
                right,
                observed,
                outputs,
                budget,
                () -> symbolic.get().flatMap(own -> own.symbolic(budget)),
                stores);
    }

    /** An engine that does not look at configurations one by one, where there is one for these. */
    private Optional<SymbolicInclusion> symbolic(Budget budget) {
        return network().flatMap(network -> SymbolicInclusion.of(network, right, outputs, budget));
    }

    /** The left side, if it can be told in bits. */
    private Optional<NetworkSystem> network() {
        return left instanceof NetworkSystem network && network.worksInSlices()
                ? Optional.of(network.smaller().system())
                : Optional.empty();
    }

    /**
     * Clauses that show the inclusion, by that engine alone.
     *
     * @param work as {@link SymbolicInclusion#work} has it
     */
    public Optional<Certificate> clauses(long work, Budget budget) {
        return symbolic(budget)
                .filter(engine -> engine.work(work) == Progress.PROVED)
                .map(engine -> Certificate.ofClauses(engine.clauses()));
    }

    /**
     * What is wrong with a certificate; empty for a proof.
     *
     * @param certificate of pairs or of clauses
     */
    Optional<String> problem(Certificate certificate, Budget budget) {
        return switch (certificate.form()) {
            case PAIRS ->
                    new CertificateCheck(left, right, observed, outputs, certificate, budget)
                            .problem();
            case CLAUSES -> clauseProblem(certificate, budget);
            case CONDITIONS ->
                    Optional.of("conditions over variables are about two automata alone");
        };
    }

    private Optional<String> clauseProblem(Certificate certificate, Budget budget) {
        Optional<NetworkSystem> network = network();
        return network.isEmpty()
                ? Optional.of("clauses are about compositions that work in slices")
                : ClauseCheck.problem(network.get(), right, outputs, certificate, budget::insist);
    }

    Explored explored(TraceInclusion inclusion) {
        return new Explored(inclusion.pairs(), inclusion.lefts(), right.size());
    }
}
