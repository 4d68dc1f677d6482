package nxt.actuators;

import lejos.nxt.Sound;

/** Platform component nxt.Speaker on the brick. */
public final class Speaker {
    /** In Hz. */
    public int frequency;

    public boolean hasFrequency;

    private final int duration;
    private final int volume;

    public Speaker(int duration, int volume) {
        this.duration = duration;
        this.volume = volume;
    }

    /** Carries out the message of a slice: the tone starts and nobody waits for its end. */
    public void act() {
        if (hasFrequency) {
            Sound.playTone(frequency, duration, volume);
        }
    }
}
