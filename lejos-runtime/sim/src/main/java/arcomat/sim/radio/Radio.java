package arcomat.sim.radio;

import arcomat.sim.time.Strand;
import arcomat.sim.time.VirtualTime;

import org.jspecify.annotations.Nullable;

import java.util.Optional;

/** The Bluetooth device of one brick. As on the NXT, it takes one connection at a time. */
public final class Radio {
    private final String name;
    private final Ether ether;
    private boolean listening;
    private @Nullable Link link;

    /** Told of a call; null if nobody waits. Looking every moment would cost the PC dear. */
    private @Nullable Runnable listener;

    Radio(String name, Ether ether) {
        this.name = name;
        this.ether = ether;
    }

    public String name() {
        return name;
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

    /**
     * Waits for a call.
     *
     * @param end when to give up, in microseconds
     */
    public Optional<Link> awaitCall(VirtualTime time, long end) {
        Strand sleeper = time.running();
        listen(() -> time.wake(sleeper));
        try {
            while (!isCalled() && time.now() < end) {
                time.waitUntil(end);
            }
        } finally {
            stopListening();
        }
        return accepted();
    }

    /**
     * From now on other radios can call this one.
     *
     * @param newListener told of the first call
     */
    public void listen(Runnable newListener) {
        listening = true;
        listener = newListener;
    }

    /** Whether another radio has made a connection that is not yet taken. */
    public boolean isCalled() {
        return link != null;
    }

    /** From now on nobody can call. */
    public void stopListening() {
        listening = false;
        listener = null;
    }

    private Link connectTo(Radio partner) {
        Channel there = ether.channel();
        Channel back = ether.channel();
        partner.listening = false;
        partner.link = new Link(name, back, there);
        if (partner.listener != null) {
            partner.listener.run();
        }
        return new Link(partner.name, there, back);
    }

    /** The connection that another radio has made; taken once. */
    public Optional<Link> accepted() {
        Optional<Link> accepted = Optional.ofNullable(link);
        link = null;
        return accepted;
    }
}
