package lejos.robotics;

/** Feels contact. */
public interface Touch {
    boolean isPressed();
}
