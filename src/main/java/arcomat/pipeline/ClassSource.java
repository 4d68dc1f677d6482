package arcomat.pipeline;

import java.util.Optional;

/** The classes that compiled code may refer to, besides those compiled together with it. */
interface ClassSource {
    /** The class file of an internal name, as {@code java/util/Map$Entry}. */
    Optional<byte[]> classFile(String name);

    /** Whether there are classes in a package of this internal name, or in one below it. */
    boolean isPackage(String name);
}
