package arcomat.brick.jar;

import arcomat.brick.api.BrickField;
import arcomat.brick.api.BrickMethod;
import arcomat.brick.api.BrickType;
import arcomat.brick.jar.ReferenceSearch.Reference;

import org.objectweb.asm.tree.ClassNode;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Types and their members, the robot's own and the brick's, with what they inherit. */
public record Hierarchy(RobotProgram program) {

    private static final String CONSTRUCTOR = "<init>";

    public boolean contains(String type) {
        return program.own(type).isPresent() || program.table().contains(type);
    }

    /**
     * Whether a type has a member or inherits it. A type with a supertype that nobody knows is
     * excused: the supertype has its own finding.
     */
    public boolean has(String owner, Reference.Member member) {
        if (member.name().equals(CONSTRUCTOR)) {
            return declares(owner, member);
        }
        return withSupertypes(owner).stream()
                .anyMatch(type -> !contains(type) || declares(type, member));
    }

    /** The brick's methods of a name that a type has or inherits. */
    public Stream<BrickMethod> methodsOfTheBrick(String owner, String name) {
        return withSupertypes(owner).stream()
                .flatMap(type -> program.table().type(type).stream())
                .flatMap(type -> type.methods().stream())
                .filter(method -> method.name().equals(name));
    }

    /** Whether a type has a member itself. */
    public boolean declares(String type, Reference.Member member) {
        return program.own(type).filter(node -> declares(node, member)).isPresent()
                || program.table().type(type).filter(t -> declares(t, member)).isPresent();
    }

    private static boolean declares(ClassNode node, Reference.Member member) {
        return member.isMethod()
                ? node.methods.stream().anyMatch(m -> member.isCalled(m.name, m.desc))
                : node.fields.stream().anyMatch(f -> member.isCalled(f.name, f.desc));
    }

    private static boolean declares(BrickType type, Reference.Member member) {
        Optional<BrickField> field = type.field(member.name());
        return member.isMethod()
                ? type.method(member.name(), member.descriptor()).isPresent()
                : field.filter(f -> f.descriptor().equals(member.descriptor())).isPresent();
    }

    /** The type first; interfaces have the methods of objects as well. */
    public Set<String> withSupertypes(String name) {
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
        Stream<String> own =
                program.own(name).stream()
                        .flatMap(n -> concat(Optional.ofNullable(n.superName), n.interfaces));
        Stream<String> ofBrick =
                program.table().type(name).stream()
                        .flatMap(t -> concat(t.superclass(), t.interfaces()));
        return Stream.concat(own, ofBrick).toList();
    }

    private static Stream<String> concat(Optional<String> first, List<String> rest) {
        return Stream.concat(first.stream(), rest.stream());
    }
}
