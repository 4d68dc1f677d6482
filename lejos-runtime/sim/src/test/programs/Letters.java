import lejos.nxt.LCD;

/** Writes over letters; the display has those of ASCII only. */
public class Letters {
    public static void main(String[] args) {
        LCD.drawString("cafe", 0, 0);
        LCD.drawString("\u00fcber", 0, 0);
        LCD.drawChar('\u20ac', 5, 0);
    }
}
