package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.Hierarchy;
import arcomat.brick.jar.JavaNames;
import arcomat.brick.jar.ReferenceSearch.Reference;
import arcomat.brick.jar.RobotProgram;
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
public final class SimulationCheck {
    public static final String CODE = "ARC0916";
    private static final String SIMULATION = "arcomat/sim/";

    private final SimulatedMembers simulated = new SimulatedMembers();
    private final RobotProgram program;
    private final Hierarchy hierarchy;

    public SimulationCheck(RobotProgram program) {
        this.program = program;
        this.hierarchy = new Hierarchy(program);
    }

    /** Warnings: the brick itself can do more. Each type and member is told once. */
    public List<Diagnostic> findings() {
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
                                "%s lies in a package of the simulated brick; move it to another one"
                                        .formatted(file.name())))
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
                "%s uses %s, which the simulated brick does not have: 'run-brick' and 'world' cannot run this program"
                        .formatted(reference.where(), missing(reference)));
    }

    /** The member, or the whole type. */
    private String missing(Reference reference) {
        return reference
                .member()
                .filter(member -> isOwn(reference.owner()) || simulated.has(reference.owner()))
                .map(member -> JavaNames.member(reference.owner(), member))
                .orElse(JavaNames.type(reference.owner()));
    }
}
