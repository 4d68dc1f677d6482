package arcomat.sim.radio;

import java.util.Optional;

/** The Bluetooth device of one brick. As on the NXT, it takes one connection at a time. */
public final class Radio {
    private final String name;
    private final Ether ether;
    private boolean listening;
    private Link link;

    Radio(String name, Ether ether) {
        this.name = name;
        this.ether = ether;
    }

    public String name() {
        return name;
    }

    /** Whether others may connect now. */
    public void listen(boolean on) {
        listening = on;
    }

    /** Whether a brick of this name has ever been seen. */
    public boolean knows(String other) {
        return ether.find(other).isPresent();
    }

    /** Connects to another radio, if that one listens. */
    public Optional<Link> connect(String other) {
        Optional<Radio> partner = ether.find(other).filter(radio -> radio.listening);
        return partner.filter(radio -> radio != this).map(this::connectTo);
    }

    private Link connectTo(Radio partner) {
        Channel there = new Channel();
        Channel back = new Channel();
        partner.listening = false;
        partner.link = new Link(name, back, there);
        return new Link(partner.name, there, back);
    }

    /** The connection that another radio has made since this one listens; taken once. */
    public Optional<Link> accepted() {
        Optional<Link> accepted = Optional.ofNullable(link);
        link = null;
        return accepted;
    }
}
