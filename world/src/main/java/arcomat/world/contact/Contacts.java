package arcomat.world.contact;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * All that may touch in one step. Whatever bodies do in the directions of their contacts, round
 * ones come no nearer than there is room: where they also move aside, they come less near.
 */
public final class Contacts {
    /** So far from each other bodies stay that touch: rounding does not make them overlap. */
    private static final double SKIN = 0.01;

    /** How fast they go apart at most, where they overlapped when all began. */
    private static final double APART = 20;

    /**
     * How often each contact is looked at: enough for a row of five bodies of about one weight.
     * What is not settled then is held by its {@link Crowd}.
     */
    private static final int ROUNDS = 60;

    private final double seconds;
    private final List<Drag> drags = new ArrayList<>();
    private final List<Contact> contacts = new ArrayList<>();

    /**
     * @param seconds of the step
     */
    public Contacts(double seconds) {
        this.seconds = seconds;
    }

    /** One body, and another one that is in no point the same. */
    public Contact of(Round one, Body body, Round other, Body otherBody) {
        double distance = one.distance(other.x(), other.y());
        return of(
                body,
                otherBody,
                (other.x() - one.x()) / distance,
                (other.y() - one.y()) / distance,
                distance - one.radius() - other.radius());
    }

    /** A body, and the nearest point of something that stands, which is not its middle. */
    public void of(Round one, Body body, double x, double y) {
        double distance = one.distance(x, y);
        double room = distance - one.radius();
        of(body, Body.FIXED, (x - one.x()) / distance, (y - one.y()) / distance, room);
    }

    /**
     * A body, and what it comes to in a direction.
     *
     * @param x of the direction, a vector of length 1
     * @param y likewise
     * @param room until they touch
     */
    public Contact of(Body one, Body other, double x, double y, double room) {
        double nearing = Math.max(-APART, (room - SKIN) / seconds);
        Contact contact = new Contact(one, other, x, y, nearing);
        contacts.add(contact);
        return contact;
    }

    /**
     * A thing that the floor holds.
     *
     * @param force of its friction, as the speed that it takes from a mass of 1 in a second
     */
    public void hold(Sliding body, double force) {
        drags.add(new Drag(body, force * seconds));
    }

    /**
     * Changes speeds until nothing comes nearer to anything than it may. Bodies together gain no
     * energy by it, even where there are too few rounds: each look at a contact, a floor or a tyre
     * minimizes their energy and, of each contact, its impulse times the speed that it allows. That
     * sum begins with the energy alone, and what it adds is never below 0.
     */
    public void settle() {
        settle(Contact::settle);
    }

    /**
     * After that: has bodies go apart that are too near each other. Speeds are then those of their
     * ways in this step. Nobody is to keep them: no motor gives them, and bodies that were pressed
     * together would leap off each other.
     */
    public void part() {
        if (contacts.stream().anyMatch(Contact::isTooNear)) {
            settle(Contact::part);
        }
    }

    private void settle(Consumer<Contact> look) {
        for (int round = 0; round < ROUNDS; round++) {
            drags.forEach(Drag::settle);
            contacts.forEach(look);
        }
    }
}
