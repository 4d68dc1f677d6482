package arcomat.pipeline.compile;

import java.util.Optional;

/** Classes that compiled code may refer to. Names have slashes: {@code java/util/List}. */
public interface ClassFiles {
    /** The class file of a name. */
    Optional<byte[]> find(String name);

    /** Whether there are classes in a package or below it. */
    boolean isPackage(String name);
}
