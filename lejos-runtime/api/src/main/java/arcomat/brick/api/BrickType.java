package arcomat.brick.api;

import org.objectweb.asm.Opcodes;

import java.util.List;
import java.util.Optional;

/**
 * A class or interface on the brick with its public and protected members.
 *
 * @param name internal name: {@code lejos/nxt/Motor}
 * @param access flags as in class files
 * @param superclass internal name; none for {@code Object} only
 * @param interfaces internal names
 * @param signature supertypes with type arguments, where there are any
 * @param nesting where it is declared, if inside of another class
 */
public record BrickType(
        String name,
        int access,
        Optional<String> superclass,
        List<String> interfaces,
        Optional<String> signature,
        Optional<Nesting> nesting,
        List<BrickField> fields,
        List<BrickMethod> methods) {

    /**
     * The place of a nested class.
     *
     * @param outer internal name of the class around it
     * @param simpleName its name there
     * @param access flags as declared, {@code static} and {@code protected} among them
     */
    public record Nesting(String outer, String simpleName, int access) {}

    public BrickType {
        interfaces = List.copyOf(interfaces);
        fields = List.copyOf(fields);
        methods = List.copyOf(methods);
    }

    public boolean isInterface() {
        return (access & Opcodes.ACC_INTERFACE) != 0;
    }

    public boolean isEnum() {
        return (access & Opcodes.ACC_ENUM) != 0;
    }

    /** The package's internal name; empty for the unnamed one. */
    public String packageName() {
        return name.substring(0, Math.max(0, name.lastIndexOf('/')));
    }

    public Optional<BrickField> field(String fieldName) {
        return fields.stream().filter(f -> f.name().equals(fieldName)).findFirst();
    }

    public Optional<BrickMethod> method(String methodName, String descriptor) {
        return methods.stream()
                .filter(m -> m.name().equals(methodName) && m.descriptor().equals(descriptor))
                .findFirst();
    }
}
