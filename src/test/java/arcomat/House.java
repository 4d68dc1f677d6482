package arcomat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;

import java.util.Set;
import java.util.TreeSet;

/**
 * The classes of the tool, room by room. Of others only the names are asked: {@code
 * archunit.properties} has nobody read those of libraries and of Java.
 */
final class House {
    static final JavaClasses CLASSES =
            new ClassFileImporter()
                    .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                    .importPackages("arcomat");

    /** Every room stands on it. */
    static final Set<String> GROUND = Set.of("source", "graph");

    /** rt and sim are built apart: programs stand on them alone. */
    static final Set<String> APART = Set.of("rt", "sim");

    private House() {}

    static Set<String> rooms() {
        Set<String> rooms = new TreeSet<>();
        CLASSES.forEach(each -> rooms.add(room(each)));
        rooms.removeAll(APART);
        return rooms;
    }

    static String room(JavaClass type) {
        return room(type.getPackageName());
    }

    static String room(String packageName) {
        String[] parts = packageName.split("\\.");
        return parts.length > 1 ? parts[1] : "";
    }
}
