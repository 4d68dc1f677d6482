package arcomat.sim.load;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/** Class files that are made once, for whoever asks first. */
final class Kept implements ClassFiles {
    private final ClassFiles made;
    private final Map<String, Optional<byte[]>> files = new ConcurrentHashMap<>();

    Kept(ClassFiles made) {
        this.made = made;
    }

    @Override
    public Optional<byte[]> find(String name) {
        Optional<byte[]> known = files.get(name);
        if (known == null) {
            known = made.find(name);
            files.put(name, known);
        }
        return known;
    }
}
