package arcomat.guest;

import arcomat.check.law.Law;

import java.util.List;

/**
 * What somebody outside adds to the tool. It is found as a service: a line with the name of the
 * class in {@code META-INF/services/arcomat.guest.Guest}. A page about each code, in Markdown, lies
 * in {@code explain/CODE.md} of the same jar.
 *
 * <p>A guest is asked once, when it arrives. It is not to keep anything between two checks: they
 * may run side by side.
 */
public interface Guest {
    /**
     * The version of all that guests see. It grows when a guest that was made before might not work
     * any more.
     */
    int API = 1;

    /**
     * The version that the guest was compiled with: {@code return API;} writes it into the class,
     * so that it stays what it was.
     */
    int api();

    /** By which findings name it: letters, digits, dots and hyphens, at most 40. */
    String name();

    /**
     * Laws in addition to those of the tool, written in the same way. Their codes are two to eight
     * capital letters, other than {@code ARC}, and four digits; no two guests of a run may have the
     * same.
     */
    default List<Law> laws() {
        return List.of();
    }

    /** Questions about automata, in addition to those of the tool. */
    default List<AutomatonAnalysis> analyses() {
        return List.of();
    }

    /** Languages for behaviours; no two guests of a run may have the same word for one. */
    default List<BehaviourLanguage> languages() {
        return List.of();
    }

    /** Forms in which results are written; no two guests of a run may have one of the same name. */
    default List<ReportForm> reportForms() {
        return List.of();
    }

    /**
     * A model root that models may refer to: files of the jar below its folder {@code library}, by
     * their paths there. Models lie in folders of their packages, {@code walls/Sensor.arc}; code
     * for platform components where it lies below any model root, {@code
     * platform/jvm/walls/sensors/Sensor.java}.
     */
    default List<String> library() {
        return List.of();
    }

    /** Models of other languages that are read each time; no two of a run may have one ending. */
    default List<FileKind> fileKinds() {
        return List.of();
    }

    /** Readers of other languages; no two guests of a run may have the same word for one. */
    default List<Importer> importers() {
        return List.of();
    }
}
