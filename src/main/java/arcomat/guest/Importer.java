package arcomat.guest;

import arcomat.source.SourceFile;

import java.util.List;

/**
 * Reads models of another language, once, and writes Arcomat models that people go on with. The
 * tool finds and reads the files, sets what was written in canonical form, and writes it.
 */
public interface Importer {
    /** The word by which {@code arcomat import} knows it: letters, digits, dots and hyphens. */
    String kind();

    /** How the names of the files end that it reads, as in {@code .arc}; at least one. */
    List<String> endings();

    /** The codes of what it finds, as those of a guest's laws, each with a page. */
    List<String> codes();

    /**
     * Reads the files of one folder, in the order of their paths.
     *
     * @param transcription takes the models, and what is wrong with the originals
     */
    void read(List<Original> originals, Transcription transcription);

    /**
     * A file of the other language.
     *
     * @param path in the folder that is imported, with forward slashes
     */
    record Original(String path, SourceFile file) {}
}
