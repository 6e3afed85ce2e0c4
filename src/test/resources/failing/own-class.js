// says: Oops [Error]: custom
class Oops extends Error{}; throw new Oops("custom");
