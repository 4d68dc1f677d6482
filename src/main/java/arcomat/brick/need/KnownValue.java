package arcomat.brick.need;

import org.objectweb.asm.Type;
import org.objectweb.asm.tree.analysis.BasicValue;

import java.util.Optional;

/**
 * A value that is the same on all ways to a place: a whole number, or an object that was made
 * before the first slice. What is not known is a plain {@link BasicValue}.
 */
final class KnownValue extends BasicValue {
    /** No object. */
    static final KnownValue NULL = object(-1);

    private static final String OBJECT = "object ";

    private final int number;

    private KnownValue(String name, int number) {
        super(Type.getObjectType(name + number)); // by which values are told apart
        this.number = number;
    }

    static KnownValue number(int number) {
        return new KnownValue("number ", number);
    }

    /**
     * @param number its place among all objects, from 0
     */
    static KnownValue object(int number) {
        return new KnownValue(OBJECT, number);
    }

    /** What a field holds of which nothing was written, where that can be known. */
    static Optional<KnownValue> nothing(String descriptor) {
        return switch (descriptor.charAt(0)) {
            case 'J', 'F', 'D' -> Optional.empty();
            case 'L', '[' -> Optional.of(NULL);
            default -> Optional.of(number(0));
        };
    }

    /** An object, or none. */
    boolean isObject() {
        return getType().getInternalName().startsWith(OBJECT);
    }

    int number() {
        return number;
    }
}
