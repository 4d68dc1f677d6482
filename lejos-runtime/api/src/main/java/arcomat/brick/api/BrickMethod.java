package arcomat.brick.api;

import java.util.List;
import java.util.Optional;

/**
 * A public or protected method or constructor of a class on the brick.
 *
 * @param name {@code <init>} for constructors
 * @param access flags as in class files
 * @param descriptor parameters and result as in class files
 * @param signature the same with type arguments, where there are any
 * @param exceptions internal names of what it declares to throw
 */
public record BrickMethod(
        String name,
        int access,
        String descriptor,
        Optional<String> signature,
        List<String> exceptions) {
    public BrickMethod {
        exceptions = List.copyOf(exceptions);
    }
}
