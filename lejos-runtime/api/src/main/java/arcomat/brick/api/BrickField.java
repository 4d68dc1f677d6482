package arcomat.brick.api;

import java.util.Optional;

/**
 * A public or protected field of a class on the brick.
 *
 * @param access flags as in class files
 * @param descriptor type as in class files
 * @param signature type with its type arguments, where it has any
 * @param constant value that compilers copy to where the field is read: an Integer (for all types
 *     that fit it), Long, Float, Double or String
 */
public record BrickField(
        String name,
        int access,
        String descriptor,
        Optional<String> signature,
        Optional<Object> constant) {}
