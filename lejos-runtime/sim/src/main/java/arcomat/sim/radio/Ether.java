package arcomat.sim.radio;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The room in which radios hear each other. */
public final class Ether {
    private final List<Radio> radios = new ArrayList<>();
    private final boolean packetsInPieces;

    /**
     * @param packetsInPieces whether some packets arrive in two parts
     */
    public Ether(boolean packetsInPieces) {
        this.packetsInPieces = packetsInPieces;
    }

    /**
     * A radio under a name by which others call it.
     *
     * @throws IllegalArgumentException if the name is taken
     */
    public Radio join(String name) {
        if (find(name).isPresent()) {
            throw new IllegalArgumentException("two bricks are called " + name);
        }
        Radio radio = new Radio(name, this);
        radios.add(radio);
        return radio;
    }

    Channel channel() {
        return new Channel(packetsInPieces);
    }

    Optional<Radio> find(String name) {
        return radios.stream().filter(radio -> radio.name().equals(name)).findFirst();
    }
}
