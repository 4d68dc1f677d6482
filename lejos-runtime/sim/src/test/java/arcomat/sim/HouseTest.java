package arcomat.sim;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;

import org.junit.jupiter.api.Test;

/** Who may know whom inside the simulated brick. */
class HouseTest {
    private static final JavaClasses CLASSES =
            new ClassFileImporter()
                    .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                    .importPackages("arcomat.sim", "lejos", "javax.microedition");

    @Test
    void packagesAreFreeOfCycles() {
        slices().matching("arcomat.sim.(*)..").should().beFreeOfCycles().check(CLASSES);
    }

    @Test
    void theControlSideNeverNamesWhatIsLoadedPerBrick() {
        noClasses()
                .that()
                .resideInAPackage("arcomat.sim..")
                .and()
                .resideOutsideOfPackage("arcomat.sim.inside")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("lejos..", "javax.microedition..", "arcomat.sim.inside")
                .check(CLASSES);
    }

    @Test
    void whatProgramsCallKnowsDevicesOnly() {
        noClasses()
                .that()
                .resideInAnyPackage("lejos..", "arcomat.sim.inside")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "arcomat.sim",
                        "arcomat.sim.load",
                        "arcomat.sim.script",
                        "arcomat.sim.trace")
                .check(CLASSES);
    }

    @Test
    void onlyTheLoaderReadsClassFiles() {
        noClasses()
                .that()
                .resideOutsideOfPackage("arcomat.sim.load")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("org.objectweb..")
                .check(CLASSES);
    }
}
