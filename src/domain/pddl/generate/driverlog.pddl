; Trucks carry packages; a truck needs a driver, and drivers walk on footpaths.
(define (domain driverlog)
  (:requirements :strips :typing)
  (:types
    place movable - object
    driver truck package - movable)
  (:predicates
    (at ?thing - movable ?place - place)
    (in ?package - package ?truck - truck)
    (driving ?driver - driver ?truck - truck)
    (empty ?truck - truck)
    (road ?from ?to - place)
    (path ?from ?to - place))

  (:action load-truck
    :parameters (?package - package ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (at ?package ?place))
    :effect (and (in ?package ?truck) (not (at ?package ?place))))

  (:action unload-truck
    :parameters (?package - package ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (in ?package ?truck))
    :effect (and (at ?package ?place) (not (in ?package ?truck))))

  (:action board-truck
    :parameters (?driver - driver ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (at ?driver ?place) (empty ?truck))
    :effect (and (driving ?driver ?truck) (not (at ?driver ?place)) (not (empty ?truck))))

  (:action leave-truck
    :parameters (?driver - driver ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (driving ?driver ?truck))
    :effect (and (at ?driver ?place) (empty ?truck) (not (driving ?driver ?truck))))

  (:action drive-truck
    :parameters (?truck - truck ?from ?to - place ?driver - driver)
    :precondition (and (at ?truck ?from) (driving ?driver ?truck) (road ?from ?to))
    :effect (and (at ?truck ?to) (not (at ?truck ?from))))

  (:action walk
    :parameters (?driver - driver ?from ?to - place)
    :precondition (and (at ?driver ?from) (path ?from ?to))
    :effect (and (at ?driver ?to) (not (at ?driver ?from)))))
