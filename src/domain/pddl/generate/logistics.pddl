; Trucks drive packages within cities, airplanes fly them between airports.
(define (domain logistics)
  (:requirements :strips :typing)
  (:types
    place movable - object
    airport - place
    package vehicle - movable
    truck airplane - vehicle)
  (:predicates
    (at ?thing - movable ?place - place)
    (in ?package - package ?vehicle - vehicle)
    (road ?from ?to - place)
    (route ?from ?to - airport))

  (:action load-truck
    :parameters (?package - package ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (at ?package ?place))
    :effect (and (in ?package ?truck) (not (at ?package ?place))))

  (:action unload-truck
    :parameters (?package - package ?truck - truck ?place - place)
    :precondition (and (at ?truck ?place) (in ?package ?truck))
    :effect (and (at ?package ?place) (not (in ?package ?truck))))

  (:action drive-truck
    :parameters (?truck - truck ?from ?to - place)
    :precondition (and (at ?truck ?from) (road ?from ?to))
    :effect (and (at ?truck ?to) (not (at ?truck ?from))))

  (:action load-airplane
    :parameters (?package - package ?airplane - airplane ?airport - airport)
    :precondition (and (at ?airplane ?airport) (at ?package ?airport))
    :effect (and (in ?package ?airplane) (not (at ?package ?airport))))

  (:action unload-airplane
    :parameters (?package - package ?airplane - airplane ?airport - airport)
    :precondition (and (at ?airplane ?airport) (in ?package ?airplane))
    :effect (and (at ?package ?airport) (not (in ?package ?airplane))))

  (:action fly-airplane
    :parameters (?airplane - airplane ?from ?to - airport)
    :precondition (and (at ?airplane ?from) (route ?from ?to))
    :effect (and (at ?airplane ?to) (not (at ?airplane ?from)))))
