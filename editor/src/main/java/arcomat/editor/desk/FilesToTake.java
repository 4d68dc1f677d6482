package arcomat.editor.desk;

import arcomat.pipeline.file.FileReader;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Texts that have been read, to be taken over some at a time, which is what takes long. The order
 * is that of taking them all at once, so that each file comes to the same root.
 */
final class FilesToTake {
    /** Files; who opens one while they are taken over waits no longer than for these. */
    private static final int FEW = 32;

    /**
     * A step goes through all that was taken before it, if only to keep it. Where it takes over a
     * fixed share of that, all steps together take no more than a multiple of one.
     */
    private static final int SHARE = 8;

    private final List<Map.Entry<Path, FileReader.Read>> files;
    private int taken;

    FilesToTake(Map<Path, FileReader.Read> files) {
        this.files = Roots.inOrder(files);
    }

    /** The next of them; nothing where there are no more. */
    Optional<Map<Path, FileReader.Read>> some() {
        if (taken == files.size()) {
            return Optional.empty();
        }
        int end = Math.min(files.size(), taken + Math.max(FEW, taken / SHARE));
        Map<Path, FileReader.Read> some = new LinkedHashMap<>();
        files.subList(taken, end).forEach(each -> some.put(each.getKey(), each.getValue()));
        taken = end;
        return Optional.of(some);
    }
}
