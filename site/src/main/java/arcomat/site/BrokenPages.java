package arcomat.site;

import java.util.Set;
import java.util.TreeSet;

/** Pages promise what is not there. The message says all of it, a line each. */
final class BrokenPages extends RuntimeException {
    private static final long serialVersionUID = 1;

    private BrokenPages(String message) {
        super(message);
    }

    /** What has been found so far, sorted. */
    static final class Problems {
        private final Set<String> found = new TreeSet<>();

        void add(Object page, String problem) {
            found.add(page + ": " + problem);
        }

        /**
         * @throws BrokenPages where something has been found
         */
        void stop() {
            if (!found.isEmpty()) {
                throw new BrokenPages(String.join("\n", found));
            }
        }
    }
}
