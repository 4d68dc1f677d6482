package arcomat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;

import java.util.List;
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
                    .withImportOption(House::isOfTheTool)
                    .importPackages("arcomat");

    /** Folders of the projects whose code the tool is: the workbench first. */
    static final List<String> WINGS =
            List.of("", "agent", "campaign", "cli", "editor", "verify", "world");

    /** Every room stands on it. */
    static final Set<String> GROUND = Set.of("source", "graph");

    /** rt and sim are built apart: programs stand on them alone. */
    static final Set<String> APART = Set.of("rt", "sim");

    private House() {}

    /** Helpers of tests, and what watches over tests, are no part of it. */
    private static boolean isOfTheTool(Location location) {
        return !location.contains("/testFixtures/") && !location.contains("/testing/");
    }

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
