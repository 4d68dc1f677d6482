package arcomat.brick;

import arcomat.brick.api.BrickField;
import arcomat.brick.api.BrickMethod;
import arcomat.brick.api.BrickType;

import org.objectweb.asm.tree.ClassNode;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Types and their members, the robot's own and the brick's, with what they inherit. */
final class Hierarchy {
    private static final String CONSTRUCTOR = "<init>";

    private final Program program;

    Hierarchy(Program program) {
        this.program = program;
    }

    boolean contains(String type) {
        return program.own(type).isPresent() || program.table().contains(type);
    }

    /**
     * Whether a type has a member or inherits it. A type with a supertype that nobody knows is
     * excused: the supertype has its own finding.
     */
    boolean has(String owner, Reference.Member member) {
        if (member.name().equals(CONSTRUCTOR)) {
            return declares(owner, member);
        }
        return withSupertypes(owner).stream()
                .anyMatch(type -> !contains(type) || declares(type, member));
    }

    /** The brick's methods of a name that a type has or inherits. */
    Stream<BrickMethod> methodsOfTheBrick(String owner, String name) {
        return withSupertypes(owner).stream()
                .flatMap(type -> program.table().type(type).stream())
                .flatMap(type -> type.methods().stream())
                .filter(method -> method.name().equals(name));
    }

    /** Whether a type has a member itself. */
    boolean declares(String type, Reference.Member member) {
        return program.own(type).filter(node -> declares(node, member)).isPresent()
                || program.table().type(type).filter(t -> declares(t, member)).isPresent();
    }

    private static boolean declares(ClassNode node, Reference.Member member) {
        return member.isMethod()
                ? node.methods.stream()
                        .anyMatch(
                                m ->
                                        m.name.equals(member.name())
                                                && m.desc.equals(member.descriptor()))
                : node.fields.stream()
                        .anyMatch(
                                f ->
                                        f.name.equals(member.name())
                                                && f.desc.equals(member.descriptor()));
    }

    private static boolean declares(BrickType type, Reference.Member member) {
        Optional<BrickField> field = type.field(member.name());
        return member.isMethod()
                ? type.method(member.name(), member.descriptor()).isPresent()
                : field.filter(f -> f.descriptor().equals(member.descriptor())).isPresent();
    }

    /** The type first; interfaces have the methods of objects as well. */
    Set<String> withSupertypes(String name) {
        Set<String> result = new LinkedHashSet<>();
        collect(name, result);
        result.add("java/lang/Object");
        return result;
    }

    private void collect(String name, Set<String> result) {
        if (result.add(name)) {
            supertypes(name).forEach(supertype -> collect(supertype, result));
        }
    }

    /** The superclass and the interfaces of a type, own or the brick's. */
    private List<String> supertypes(String name) {
        List<String> result = new ArrayList<>();
        program.own(name)
                .ifPresent(
                        node -> {
                            Optional.ofNullable(node.superName).ifPresent(result::add);
                            result.addAll(node.interfaces);
                        });
        program.table()
                .type(name)
                .ifPresent(
                        type -> {
                            type.superclass().ifPresent(result::add);
                            result.addAll(type.interfaces());
                        });
        return result;
    }
}
