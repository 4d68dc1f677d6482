package arcomat.guest;

import arcomat.source.SourceFile;

import java.util.List;

/**
 * Models of another language that stay what they are: commands read them each time, beside the
 * tool's own, and what is told about them points into their text. Each file stands for one
 * component.
 */
public interface FileKind {
    /** How the names of the files end, as in {@code .note}; at least one, and none of Arcomat's. */
    List<String> endings();

    /** The codes of what may be wrong with a file, as those of a guest's laws, each with a page. */
    default List<String> codes() {
        return List.of();
    }

    /**
     * Says what a file means.
     *
     * @param meaning takes the text of the component in Arcomat's words, package and imports
     *     included, and what is wrong with the file
     */
    void translate(SourceFile file, Meaning meaning);
}
