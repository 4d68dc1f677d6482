package arcomat.brick;

import arcomat.sim.load.SimulatedMembers;
import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.ClassNode;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * ARC0916: what is on the brick and not on a simulated one. A program that names it would break off
 * with an error of the PC's machine, or reach the PC itself: its files, its network.
 */
final class SimulationCheck {
    static final String CODE = "ARC0916";
    private static final String SIMULATION = "arcomat/sim/";

    private final SimulatedMembers simulated = new SimulatedMembers();
    private final Program program;
    private final Hierarchy hierarchy;

    SimulationCheck(Program program) {
        this.program = program;
        this.hierarchy = new Hierarchy(program);
    }

    /** Warnings: the brick itself can do more. Each type and member is told once. */
    List<Diagnostic> findings() {
        List<Diagnostic> findings =
                new ArrayList<>(program.inClasses(SimulationCheck::ownPlace).toList());
        Set<String> told = new HashSet<>();
        for (Reference each : program.references()) {
            if (!isSimulated(each) && told.add(missing(each))) {
                findings.add(finding(each));
            }
        }
        return findings;
    }

    private static Stream<Diagnostic> ownPlace(ClassFile file, ClassNode node) {
        return node.name.startsWith(SIMULATION)
                ? Stream.of(
                        Diagnostic.warning(
                                CODE,
                                file.span(),
                                file.name()
                                        + " lies in a package of the simulated brick; move it to"
                                        + " another one"))
                : Stream.empty();
    }

    /** What leJOS does not have either has its own finding. */
    private boolean isSimulated(Reference reference) {
        if (!hierarchy.contains(reference.owner())) {
            return true;
        }
        if (reference.member().isEmpty()) {
            return isOwn(reference.owner()) || simulated.has(reference.owner());
        }
        Reference.Member member = reference.member().get();
        return !hierarchy.has(reference.owner(), member)
                || hierarchy.withSupertypes(reference.owner()).stream()
                        .anyMatch(type -> offers(type, member));
    }

    private boolean offers(String type, Reference.Member member) {
        return isOwn(type)
                ? hierarchy.declares(type, member)
                : simulated.has(type, member.name(), member.descriptor());
    }

    private boolean isOwn(String type) {
        return program.own(type).isPresent();
    }

    private Diagnostic finding(Reference reference) {
        return Diagnostic.warning(
                CODE,
                reference.span(),
                reference.where()
                        + " uses "
                        + missing(reference)
                        + ", which the simulated brick does not have: 'run-brick' and 'world'"
                        + " cannot run this program");
    }

    /** The member, or the whole type. */
    private String missing(Reference reference) {
        return reference
                .member()
                .filter(member -> isOwn(reference.owner()) || simulated.has(reference.owner()))
                .map(member -> Names.member(reference.owner(), member))
                .orElse(Names.type(reference.owner()));
    }
}
