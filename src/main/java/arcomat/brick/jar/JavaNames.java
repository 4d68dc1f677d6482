package arcomat.brick.jar;

import arcomat.brick.jar.ReferenceSearch.Reference;

import org.objectweb.asm.Type;

import java.util.Arrays;
import java.util.stream.Collectors;

/** Names of class files as people write them. */
public final class JavaNames {
    private static final String CONSTRUCTOR = "<init>";

    private JavaNames() {}

    /**
     * {@code java.util.Map.Entry} of {@code java/util/Map$Entry}; classes without name keep theirs.
     */
    public static String type(String internalName) {
        return internalName.replace('/', '.').replaceAll("\\$(?=\\p{L})", ".");
    }

    /** The last part of a type's name. */
    public static String simple(String internalName) {
        return type(internalName).replaceFirst(".*\\.", "");
    }

    /** {@code String.indexOf(int, String)}, {@code new Motor()}, {@code SensorPort.S5}. */
    public static String member(String owner, Reference.Member member) {
        if (!member.isMethod()) {
            return simple(owner) + "." + member.name();
        }
        String method = method(owner, member.name(), member.descriptor());
        return member.name().equals(CONSTRUCTOR) ? "new " + method : simple(owner) + "." + method;
    }

    /** {@code indexOf(int, String)}; a constructor has the name of its class. */
    public static String method(String owner, String name, String descriptor) {
        String parameters =
                Arrays.stream(Type.getArgumentTypes(descriptor))
                        .map(type -> simple(type.getClassName()))
                        .collect(Collectors.joining(", "));
        return (name.equals(CONSTRUCTOR) ? simple(owner) : name) + "(" + parameters + ")";
    }
}
