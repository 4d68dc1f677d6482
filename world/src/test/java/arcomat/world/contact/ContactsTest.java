package arcomat.world.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleSupplier;

/** Impulses between bodies. */
class ContactsTest {
    private static final double SECONDS = 0.01;

    /** Bodies that meet, each with its energy. */
    private static final class Meeting {
        private final Random random;
        private final Contacts contacts = new Contacts(SECONDS);
        private final List<Body> bodies = new ArrayList<>(List.of(Body.FIXED));
        private final List<DoubleSupplier> energies = new ArrayList<>();

        /** Too many contacts between too unequal bodies to be settled in time. */
        Meeting(long seed) {
            random = new Random(seed);
            for (int i = 0; i < 3; i++) {
                slide();
                roll();
            }
            for (int i = 0; i < 12; i++) {
                double angle = between(0, 2 * Math.PI);
                contacts.of(any(), any(), Math.cos(angle), Math.sin(angle), between(-1, 1));
            }
        }

        private void slide() {
            double mass = Math.pow(10, between(1, 4));
            Sliding body = new Sliding(mass, between(-500, 500), between(-500, 500));
            contacts.hold(body, mass * between(0, 9000));
            bodies.add(body);
            energies.add(() -> mass * Math.pow(body.along(), 2) / 2);
            energies.add(() -> mass * Math.pow(body.across(), 2) / 2);
        }

        private void roll() {
            double mass = Math.pow(10, between(1, 4));
            double angle = between(0, 2 * Math.PI);
            double x = Math.cos(angle);
            double y = Math.sin(angle);
            Rolling body =
                    random.nextBoolean()
                            ? Rolling.free(mass, x, y, between(-500, 500))
                            : Rolling.held(mass, x, y, between(-5, 5));
            bodies.add(body);
            energies.add(() -> mass * Math.pow(body.speed(), 2) / 2);
        }

        private double between(double least, double most) {
            return least + (most - least) * random.nextDouble();
        }

        private Body any() {
            return bodies.get(random.nextInt(bodies.size()));
        }

        double energy() {
            return energies.stream().mapToDouble(DoubleSupplier::getAsDouble).sum();
        }
    }

    /** Even where they are too near each other, and where not all is settled in the end. */
    @Property(tries = 1000)
    void bodiesTogetherGainNoEnergy(@ForAll long seed) {
        Meeting meeting = new Meeting(seed);
        double before = meeting.energy();
        meeting.contacts.settle();
        assertThat(meeting.energy()).isLessThanOrEqualTo(before * (1 + 1e-9));
    }

    @Test
    void bodiesThatAreTooNearGoApartForThisStep() {
        Sliding one = new Sliding(100, 0, 0);
        Sliding other = new Sliding(300, 0, 0);
        Contacts contacts = new Contacts(SECONDS);
        // 0.1 mm and the skin in 0.01 s are 11 mm/s, of which the lighter one goes three quarters.
        contacts.of(one, other, 1, 0, -0.1);
        contacts.settle();
        assertThat(one.along()).isZero();
        assertThat(other.along()).isZero();
        contacts.part();
        assertThat(one.along()).isCloseTo(-8.25, within(1e-9));
        assertThat(other.along()).isCloseTo(2.75, within(1e-9));
    }

    @Test
    void bodiesThatHaveRoomKeepTheirSpeeds() {
        Sliding one = new Sliding(100, 50, 0);
        Contacts contacts = new Contacts(SECONDS);
        contacts.of(one, Body.FIXED, 1, 0, 0.11);
        contacts.settle();
        double speed = one.along();
        contacts.part();
        assertThat(speed).isCloseTo(10, within(1e-9));
        assertThat(one.along()).isEqualTo(speed);
    }

    /** A robot of 900 g that still rolls at 4 mm/s runs into a safe of 9 kg: it has 3600 g mm/s. */
    @Test
    void aHeldRobotPushesWithWhatItStillHas() {
        Rolling robot = Rolling.held(900, 1, 0, 4);
        Sliding safe = new Sliding(9000, 0, 0);
        Contacts contacts = new Contacts(SECONDS);
        contacts.of(robot, safe, 1, 0, 0);
        contacts.settle();
        assertThat(safe.along()).isCloseTo(3600 / 9900.0, within(1e-9));
        assertThat(robot.speed()).isCloseTo(3600 / 9900.0, within(1e-9));
    }

    @Test
    void tyresHoldARobotAgainstPushes() {
        Rolling standing = Rolling.held(900, 1, 0, 0);
        Rolling rolling = Rolling.held(900, 1, 0, 4);
        assertThat(standing.mobility(1, 0)).isZero();
        standing.push(1e6, 1, 0);
        rolling.push(1e6, 1, 0);
        assertThat(standing.speed()).isZero();
        assertThat(rolling.speed()).isEqualTo(4);
        rolling.push(-1e7, 1, 0);
        assertThat(rolling.speed()).isZero();
    }
}
